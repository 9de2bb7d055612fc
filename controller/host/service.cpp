// SPDX-License-Identifier: Apache-2.0
#include "service.h"

#include "input_pins.h"
#include "line_statements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace campanel::controller {
namespace {

constexpr double nsPerUs = 1000.0;
// The maximum sleep: the machine is not visible between two requests, so it need not be updated more often.
constexpr std::int64_t longestSleepNs = 20'000'000;
// The maximum number of steps to catch up; a larger delay of the simulated time is permanent.
constexpr std::uint64_t maxSteps = 100'000;

std::int64_t monotonicNs()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<std::int64_t>(time.tv_sec) * nsPerS + time.tv_nsec;
}

ctl_config configOf(const Options& options)
{
    ctl_config config{};
    config.unit = options.unit;
    // The core's clock is simulated time, the line's is real time.
    config.frame_gap_us = static_cast<std::uint32_t>(
        std::max(1.0, std::ceil(static_cast<double>(frameGapNs(options.line)) / nsPerUs * options.speed)));
    config.firmware[0] = CAMPANEL_VERSION_MAJOR;
    config.firmware[1] = CAMPANEL_VERSION_MINOR;
    config.firmware[2] = CAMPANEL_VERSION_PATCH;
    // The identity of a board is its flash: the same directory is the same controller.
    config.unique_id = std::hash<std::string>{}(std::filesystem::absolute(options.stateDirectory).string());
    config.timer_clock_hz = 8'000'000;
    config.timer_bits = 16;
    config.max_pulse_hz = 200'000;
    config.map_minor = options.mapMinor;
    if (options.keepsPositions)
        config.kept_positions =
            1u << CTL_IO_BIT_AXIS_KEPT | 1u << CTL_IO_BIT_FILM_KEPT | 1u << CTL_IO_BIT_INFEED_KEPT;
    return config;
}

} // namespace

Service::Service(const Options& options, ServedPort& port, FlashDevice& flash)
    : m_options(options)
    , m_port(port)
    , m_flash(flash)
    , m_line(options.line, options.faults, monotonicNs())
    , m_control(options.control ? STDIN_FILENO : -1)
    , m_gapNs(frameGapNs(options.line))
{
    powerUp(monotonicNs());
}

void Service::powerUp(std::int64_t nowNs)
{
    m_startNs = nowNs;
    m_frameEndNs.reset();
    m_lastCut.reset();
    if (m_controller) // the line is somebody else's
        m_options.machine.shaft = m_controller->machine().shaft().options();
    m_controller = std::make_unique<SimulatedController>(configOf(m_options), m_options.machine, m_flash);
}

std::uint64_t Service::simulatedUs(std::int64_t timeNs) const
{
    return static_cast<std::uint64_t>(
        std::max(0.0, static_cast<double>(timeNs - m_startNs) * m_options.speed / nsPerUs));
}

void Service::catchUp(std::int64_t nowNs)
{
    const std::uint64_t targetUs = simulatedUs(nowNs);
    const std::uint64_t reachableUs = m_controller->nowUs() + maxSteps * SimulatedController::usualStepUs;
    const std::uint64_t endUs = std::min(targetUs, reachableUs);
    while (m_controller->nowUs() + SimulatedController::usualStepUs <= endUs) {
        m_controller->step();
        if (m_controller->cut())
            m_lastCut = m_controller->cut();
    }
    m_controller->runTo(endUs);
    if (targetUs > reachableUs)
        m_startNs += static_cast<std::int64_t>(static_cast<double>(targetUs - reachableUs) * nsPerUs /
                                               m_options.speed);
}

void Service::takeAnswer(std::int64_t nowNs)
{
    std::array<std::uint8_t, CTL_FRAME_BYTES> answer{};
    const std::size_t size = ctl_take_answer(&m_controller->core(), answer.data());
    if (size > 0)
        m_line.fromController({answer.data(), size}, m_frame, nowNs);
}

void Service::moveBytes(std::int64_t nowNs)
{
    while (const auto event = m_line.takeEvent(nowNs))
        act(*event, nowNs);
    while (const auto arrival = m_line.takeArrival(nowNs)) {
        catchUp(arrival->endNs);
        ctl_receive(&m_controller->core(), arrival->bytes.data(), arrival->bytes.size(),
                    simulatedUs(arrival->endNs));
        takeAnswer(arrival->endNs); // for the previous frame: the next one would overtake it
        m_frame = arrival->frame;
        m_frameEndNs = arrival->endNs + m_gapNs;
    }
    catchUp(nowNs);
    if (m_frameEndNs && *m_frameEndNs <= nowNs)
        m_frameEndNs.reset();
    takeAnswer(nowNs);
    const auto forPanel = m_line.takeForPanel(nowNs);
    if (!forPanel.empty())
        m_port.write(forPanel);
}

void Service::act(const LineEvent& event, std::int64_t nowNs)
{
    switch (event.kind) {
    case LineEvent::Kind::Unplug:
        m_port.unplug();
        say("unplugged");
        return;
    case LineEvent::Kind::Plug:
        if (const auto plugged = m_port.plug(event.port); !plugged)
            std::fprintf(stderr, "campanel-controller: %s\n", plugged.error().c_str());
        say("port " + m_port.path());
        return;
    case LineEvent::Kind::Restart:
        powerUp(nowNs);
        say("restarted");
        return;
    }
}

// Prints a line for the process that sends the rules on standard input.
void Service::say(std::string_view line) const
{
    if (!m_options.control)
        return;
    std::printf("%.*s\n", static_cast<int>(line.size()), line.data());
    std::fflush(stdout);
}

// Prints the measurements of the last bag.
void Service::measure() const
{
    if (!m_lastCut) {
        say("measured none");
        return;
    }
    std::array<char, 64> text{};
    if (m_lastCut->lengthUm)
        std::snprintf(text.data(), text.size(), "measured %.3f %.3f", *m_lastCut->lengthUm / umPerMm,
                      m_lastCut->markErrorMm);
    else
        std::snprintf(text.data(), text.size(), "measured ? %.3f", m_lastCut->markErrorMm);
    say(text.data());
}

// Sets a pin of the machine, which outlives a restart of the controller.
void Service::setPin(std::string_view text)
{
    const auto pin = parsePinStatement(text);
    if (!pin) {
        say("error unknown pin or level: " + std::string(text));
        return;
    }
    const unsigned mask = 1u << pin->bit;
    std::uint16_t& inputs = m_options.machine.inputs;
    inputs = static_cast<std::uint16_t>(pin->isOn ? inputs | mask : inputs & ~mask);
    m_controller->machine().setInput(pin->bit, pin->isOn);
    say("pin " + std::string(text));
}

void Service::moveLine(std::string_view text) const
{
    if (applyLineStatement(text, m_controller->machine().shaft()))
        say("line " + std::string(text));
    else
        say("error unknown statement about the line, or no encoder: " + std::string(text));
}

void Service::takeControlLine(std::string_view text)
{
    constexpr std::string_view pin = "pin ";
    constexpr std::string_view line = "line ";
    if (text == "measure") {
        measure();
        return;
    }
    if (text.starts_with(pin)) {
        setPin(text.substr(pin.size()));
        return;
    }
    if (text.starts_with(line)) {
        moveLine(text.substr(line.size()));
        return;
    }
    if (text == "jam on" || text == "jam off") {
        m_controller->machine().jaws().setBlocked(text == "jam on");
        say(text);
        return;
    }
    const auto script = parseFaultScript(text, m_line.script());
    if (!script) {
        say("error " + script.error());
        return;
    }
    const std::uint64_t applied = m_line.applied();
    m_line.setScript(*script, monotonicNs());
    say("ok " + std::to_string(applied));
}

void Service::wait(std::int64_t nowNs, const sigset_t& waitMask)
{
    std::int64_t untilNs = nowNs + longestSleepNs;
    untilNs = std::min(untilNs, m_frameEndNs.value_or(untilNs));
    untilNs = std::min(untilNs, m_line.nextEventNs().value_or(untilNs));
    const std::int64_t sleepNs = std::max<std::int64_t>(0, untilNs - monotonicNs());
    const timespec timeout{0, static_cast<long>(sleepNs)};
    std::array<pollfd, 3> descriptors{{{m_port.descriptor(), POLLIN, 0},
                                       {m_port.closeWatch(), POLLIN, 0},
                                       {m_control.descriptor(), POLLIN, 0}}};
    if (ppoll(descriptors.data(), descriptors.size(), &timeout, &waitMask) <= 0)
        return;
    if ((descriptors[1].revents & POLLIN) != 0)
        m_port.afterClose();
    if ((descriptors[0].revents & POLLIN) != 0) {
        std::array<std::uint8_t, 512> bytes{};
        const std::size_t size = m_port.read(bytes);
        if (size > 0)
            m_line.fromPanel({bytes.data(), size}, monotonicNs());
    }
    if (descriptors[2].revents != 0)
        m_control.read([this](std::string_view line) { takeControlLine(line); });
}

void Service::run(const volatile std::sig_atomic_t& stop, const sigset_t& waitMask)
{
    while (stop == 0) {
        const std::int64_t nowNs = monotonicNs();
        moveBytes(nowNs);
        wait(nowNs, waitMask);
    }
}

} // namespace campanel::controller
