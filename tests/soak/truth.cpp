// SPDX-License-Identifier: Apache-2.0
#include "truth.h"

#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"
#include "tests/support/cam_image.h"

#include <algorithm>

namespace campanel::soak {
namespace {

using std::chrono::milliseconds;

// The tolerance for steps of the simulation and rounding of the registers.
constexpr milliseconds clockTolerance{3};
// The time after a start until the axis is at rest again.
constexpr milliseconds longestMove{1000};
constexpr std::uint16_t parametersBegin = CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT;
constexpr std::uint16_t parametersEnd = CTL_REG_PARAMETER_MASTER_DIRECTION + 1;

std::string differs(const char* what, std::int64_t believed, std::int64_t truth)
{
    return std::string(what) + " " + std::to_string(believed) + ", truly " + std::to_string(truth);
}

} // namespace

std::vector<Image> knownImages()
{
    std::vector<Image> images;
    // Cycles of 10 to 24 ms, 2 to 13 blocks.
    for (unsigned i = 0; i < 8; ++i) {
        auto move = test::quinticMove(pulsesOfMove, 40 + 37 * i, 80'000 + 16'000 * i);
        images.push_back(move.registers());
    }
    return images;
}

std::string ControllerClock::check(std::uint32_t uptimeS, std::uint16_t sampleTimeMs, Clock::time_point asked,
                                   Clock::time_point answered)
{
    // Both count from power-up, so that one must fit into the second of the other.
    const auto withinSecond = static_cast<std::uint16_t>(sampleTimeMs - uptimeS * 1000u);
    if (withinSecond >= 1000)
        return "sample time " + std::to_string(sampleTimeMs) + " ms does not belong to uptime " +
               std::to_string(uptimeS) + " s";
    const milliseconds age{static_cast<std::int64_t>(uptimeS) * 1000 + withinSecond};
    const auto wrong =
        m_time == ControllerTime::Steady ? checkSteady(age, asked, answered) : checkStanding(age, answered);
    if (wrong.empty())
        m_age = age;
    return wrong;
}

std::string ControllerClock::checkSteady(milliseconds age, Clock::time_point asked,
                                         Clock::time_point answered)
{
    const auto earliest =
        std::max(asked - age - milliseconds{1}, m_earliest.value_or(asked - age - milliseconds{1}));
    const auto latest = std::min(answered - age, m_latest.value_or(answered - age));
    if (earliest > latest + clockTolerance)
        return "taken " +
               std::to_string(std::chrono::duration_cast<milliseconds>(earliest - latest).count()) +
               " ms outside of question and answer";
    m_earliest = earliest;
    m_latest = latest;
    return {};
}

std::string ControllerClock::checkStanding(milliseconds age, Clock::time_point answered) const
{
    if (age < m_age)
        return "goes back by " + std::to_string((m_age - age).count()) + " ms";
    if (m_powerUp + age > answered + clockTolerance)
        return "counts " + std::to_string(age.count()) + " ms, more than since power-up";
    return {};
}

Truth::Truth(ControllerTime time, Clock::time_point powerUp)
    : m_time(time)
    , m_powerUp(powerUp)
    , m_lastAnswer(powerUp)
    , m_clock(time, powerUp)
{
    for (Image& image : knownImages()) {
        m_crcs.push_back(modbus::crc32OfRegisters(image));
        m_images[m_crcs.back()] = std::move(image);
    }
}

void Truth::restarted()
{
    m_now = m_flash;
    m_pendingCrc.reset();
    m_perhaps.clear();
    m_commands = 0;
    m_counterBase.reset();
    m_starts = 0;
    m_linkRequests.reset();
    m_powerUp = m_lastAnswer;
    resetClock();
}

void Truth::saved()
{
    m_flash = m_now;
}

void Truth::commandCarriedOut(bool isStart)
{
    ++m_commands;
    if (isStart) {
        ++m_starts;
        m_startAge.reset();
    }
}

void Truth::writing(std::uint16_t address, std::span<const std::uint16_t> registers)
{
    for (const std::uint16_t value : registers)
        m_perhaps[address++].insert(value);
}

void Truth::written(std::uint16_t address, std::span<const std::uint16_t> registers)
{
    for (const std::uint16_t value : registers) {
        m_perhaps.erase(address);
        m_now.parameters[address++] = value;
    }
}

void Truth::refused(std::uint16_t address, std::span<const std::uint16_t> registers)
{
    for (const std::uint16_t value : registers)
        m_perhaps[address++].erase(value);
}

void Truth::applying(std::uint32_t crc)
{
    m_pendingCrc = crc;
}

std::string Truth::checkProgram(const modbus::StatusBlock& status)
{
    const std::uint32_t crc = status.activeCrc.value_or(0);
    if (m_pendingCrc && crc == *m_pendingCrc && status.generation == m_now.generation + 1) {
        m_now.crc = crc;
        m_now.generation = status.generation;
        m_pendingCrc.reset();
    }
    if (crc != m_now.crc)
        return differs("active CRC-32", crc, m_now.crc);
    if (status.generation != m_now.generation)
        return differs("generation", status.generation, m_now.generation);
    if (status.savedCrc.value_or(0) != m_flash.crc)
        return differs("saved CRC-32", status.savedCrc.value_or(0), m_flash.crc);
    const auto kind = crc == 0 ? modbus::ProgramKind::None : modbus::ProgramKind::PositionMove;
    if (status.programKind != kind)
        return differs("program kind", static_cast<int>(status.programKind), static_cast<int>(kind));
    return {};
}

bool Truth::stands(const modbus::StatusBlock& status) const
{
    return status.state == (m_now.crc == 0 ? modbus::State::Idle : modbus::State::Ready);
}

std::string Truth::checkState(const modbus::StatusBlock& status)
{
    if (!status.state)
        return "an unknown state";
    if (status.faultBits != 0)
        return differs("fault bits", status.faultBits, 0);
    if (!m_startAge)
        m_startAge = m_clock.age();
    const bool mayRun = m_starts > 0 && m_clock.age() < *m_startAge + longestMove;
    const bool runs = status.state == modbus::State::Running || status.state == modbus::State::Stopping;
    if (!stands(status) && !(runs && mayRun))
        return differs("state", static_cast<int>(*status.state), static_cast<int>(modbus::State::Ready));
    return {};
}

std::string Truth::checkCommands(const modbus::StatusBlock& status)
{
    if (!m_counterBase && m_commands > 0)
        m_counterBase = static_cast<std::uint16_t>(status.commandCounter - m_commands);
    const auto counter = static_cast<std::uint16_t>(m_counterBase.value_or(0) + m_commands);
    if (status.commandCounter != counter)
        return differs("command counter", status.commandCounter, counter);
    // One start is one cycle of this many pulses.
    const bool isUnderWay = !stands(status) && status.cycleCount + 1 == m_starts;
    if (status.cycleCount != m_starts && !isUnderWay)
        return differs("cycles", status.cycleCount, m_starts);
    const auto position = static_cast<std::int32_t>(m_starts) * pulsesOfMove;
    if (stands(status) && status.commandedPositionPulses != position)
        return differs("position", status.commandedPositionPulses, position);
    return {};
}

std::string Truth::checkStatus(const modbus::StatusBlock& status, Clock::time_point asked,
                               Clock::time_point answered)
{
    if (auto wrong = m_clock.check(status.uptimeS, status.sampleTimeMs, asked, answered); !wrong.empty())
        return wrong;
    // The counter increases with every answer, so that no two status blocks may have the same.
    const auto more = static_cast<std::uint16_t>(
        status.linkRequests - m_linkRequests.value_or(static_cast<std::uint16_t>(status.linkRequests - 1)));
    if (more == 0 || more > 0x8000)
        return differs("answers counted", status.linkRequests, *m_linkRequests);
    m_linkRequests = status.linkRequests;
    m_lastAnswer = answered;
    if (auto wrong = checkProgram(status); !wrong.empty())
        return wrong;
    return checkState(status);
}

std::string Truth::checkBankSlice(std::size_t offset, std::span<const std::uint16_t> registers) const
{
    const auto fits = [&](std::uint32_t crc) {
        const auto found = m_images.find(crc);
        if (found == m_images.end())
            return false;
        const Image& image = found->second;
        for (std::size_t i = 0; i < registers.size(); ++i) {
            // Behind the image the bank contains zeros.
            if (registers[i] != (offset + i < image.size() ? image[offset + i] : 0))
                return false;
        }
        return true;
    };
    if (fits(m_now.crc) || (m_pendingCrc && fits(*m_pendingCrc)))
        return {};
    return "registers of the active bank from " + std::to_string(offset) + " are not those of the program";
}

std::string Truth::checkRegisters(std::uint16_t address, std::span<const std::uint16_t> registers)
{
    if (address >= CTL_REG_ACTIVE && address < CTL_REG_STAGED)
        return checkBankSlice(address - CTL_REG_ACTIVE, registers);
    for (std::size_t i = 0; i < registers.size(); ++i) {
        const auto at = static_cast<std::uint16_t>(address + i);
        const std::uint16_t value = registers[i];
        if (at <= CTL_REG_IDENTITY_MAX_PULSE_FREQUENCY + 1) {
            if (const auto [known, isNew] = m_identity.try_emplace(at, value); known->second != value)
                return differs("an identity register", value, known->second);
        } else if (at >= parametersBegin && at < parametersEnd) {
            const auto perhaps = m_perhaps.find(at);
            if (perhaps != m_perhaps.end() && perhaps->second.contains(value)) {
                m_now.parameters[at] = value;
            } else if (const auto [known, isNew] = m_now.parameters.try_emplace(at, value);
                       known->second != value) {
                return differs("a parameter register", value, known->second);
            }
            m_perhaps.erase(at); // read, and therefore certain again
        }
    }
    return {};
}

std::string Truth::checkBank(const std::vector<std::uint16_t>& registers) const
{
    const std::uint32_t crc = modbus::crc32OfRegisters(registers);
    if (!m_images.contains(crc))
        return "the active bank is none of the tables that were ever sent";
    if (crc != m_now.crc)
        return "the active bank is another table than the status says";
    return {};
}

} // namespace campanel::soak
