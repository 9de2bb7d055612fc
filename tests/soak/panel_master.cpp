// SPDX-License-Identifier: Apache-2.0
#include "panel_master.h"

#include "modbus/download/bank_reader.h"
#include "modbus/map/codec.h"
#include "tests/support/cam_image.h"

#include <stdexcept>

namespace campanel::soak {
namespace {

using modbus::LinkErrorKind;
using std::chrono::milliseconds;

// The pause between two attempts to find the controller, as in app/link.
constexpr milliseconds retryDelay{250};
constexpr milliseconds reconnectLimit{2000};
constexpr milliseconds longestSearch{20'000};

const char* nameOf(LinkErrorKind kind)
{
    switch (kind) {
    case LinkErrorKind::PortAbsent:
        return "port absent";
    case LinkErrorKind::PortGone:
        return "port gone";
    case LinkErrorKind::NoAnswer:
        return "no answer";
    case LinkErrorKind::BadChecksum:
        return "bad checksum";
    case LinkErrorKind::BadFrame:
        return "bad frame";
    case LinkErrorKind::ForeignAnswer:
        return "foreign answer";
    case LinkErrorKind::Exception:
        return "exception";
    case LinkErrorKind::NotCamPanel:
        return "other device";
    case LinkErrorKind::WrongMapMajor:
        return "other map version";
    case LinkErrorKind::CommandLost:
        return "command lost";
    case LinkErrorKind::OutcomeUnknown:
        return "outcome unknown";
    case LinkErrorKind::ReadBackDiffers:
        return "reads back differently";
    default:
        return "another error";
    }
}

} // namespace

milliseconds MasterSettings::statusTimeout() const
{
    return std::chrono::ceil<milliseconds>(modbus::pairTime(line, modbus::statusFrames) + answerAllowance);
}

std::string rulesFor(const FaultClass& faults, const MasterSettings& settings,
                     const FaultyController& controller)
{
    std::string rules = "seed " + std::to_string(settings.seed);
    rules += "; timeout " + std::to_string(settings.statusTimeout().count()) + "; ";
    rules += faults.rules;
    for (const auto& [mark, path] :
         {std::pair{"@other", controller.otherPort()}, {"@port", controller.port()}}) {
        if (const auto at = rules.find(mark); at != std::string::npos)
            rules.replace(at, std::string_view(mark).size(), path);
    }
    return rules;
}

PanelMaster::PanelMaster(FaultyController& controller, const FaultClass& faults,
                         const MasterSettings& settings, Tally& tally, Watch& watch)
    : m_controller(controller)
    , m_faults(faults)
    , m_settings(settings)
    , m_tally(tally)
    , m_watch(watch)
    , m_truth(settings.time, controller.started())
    , m_random(settings.seed)
    , m_session(static_cast<std::uint16_t>(settings.seed))
{
}

PanelMaster::~PanelMaster() = default;

std::uint32_t PanelMaster::pick(std::uint32_t bound)
{
    return static_cast<std::uint32_t>(m_random() % bound);
}

void PanelMaster::noteEvents()
{
    const auto now = m_controller.events();
    m_replugOpen = m_replugOpen || now.plugs != m_seen.plugs;
    if (now.restarts != m_seen.restarts) {
        m_truth.restarted();
        m_restartOpen = true;
    }
    m_seen = now;
}

void PanelMaster::noteError(const modbus::LinkError& error)
{
    ++m_tally.errors[nameOf(error.kind)];
    if (modbus::portIsLost(error)) {
        m_client.reset();
    }
}

bool PanelMaster::tryToConnect()
{
    m_client = std::make_unique<modbus::RtuClient>(
        modbus::LinkSettings{m_controller.portNow(), m_settings.line, 1, m_settings.answerAllowance},
        m_record);
    if (const auto opened = timed("open", 1, Slow::No, [this] { return m_client->open(); }); !opened) {
        noteError(opened.error());
        m_client.reset();
        return false;
    }
    const auto identity = timed("identify", 2, Slow::No, [this] { return m_client->identify(); });
    if (!identity) {
        noteError(identity.error());
        m_client.reset();
        return false;
    }
    if (identity->mapMajor != modbus::mapMajor || identity->deviceType != modbus::deviceType)
        m_tally.find(m_tally.wrong, "took another device for a controller");
    m_identity = *identity;
    if (m_download)
        m_download->resume();
    return true;
}

void PanelMaster::connect()
{
    const auto begun = Clock::now();
    while (!m_client && !tryToConnect()) {
        if (Clock::now() > begun + m_settings.patience(longestSearch))
            throw std::runtime_error("the controller was not found again");
        std::this_thread::sleep_for(retryDelay);
    }
}

std::int64_t PanelMaster::unbelievedAnswers() const
{
    const auto& figures = m_record->figures;
    const auto counts = figures.controller();
    return counts ? counts->requests - static_cast<std::int64_t>(figures.answers()) : 0;
}

// Time in which a stopped controller could not answer does not count.
void PanelMaster::noteReturn(const char* what, Clock::duration took, std::vector<double>& times)
{
    constexpr int fewAnswers = 24; // to some attempts of identity and status
    times.push_back(std::chrono::duration<double, std::milli>(took).count());
    const bool couldAnswer = m_settings.time == ControllerTime::Steady ||
                             unbelievedAnswers() - m_unbelievedBefore > fewAnswers;
    if (took > reconnectLimit && couldAnswer)
        m_tally.find(m_tally.hangs, std::string(what) + ": found again after " +
                                        std::to_string(std::chrono::ceil<milliseconds>(took).count()) +
                                        " ms");
}

void PanelMaster::noteGoodStatus()
{
    if (std::exchange(m_replugOpen, false))
        noteReturn("port", Clock::now() - m_seen.lastPlug, m_tally.replugMs);
    if (std::exchange(m_restartOpen, false))
        noteReturn("controller", Clock::now() - m_seen.lastRestart, m_tally.restartMs);
    m_unbelievedBefore = unbelievedAnswers();
}

void PanelMaster::pollStatus()
{
    const std::uint16_t heartbeat = ++m_heartbeat;
    const auto asked = Clock::now();
    const auto status = timed("status", 1, Slow::No, [&] { return m_client->exchangeStatus(heartbeat, 0); });
    const auto answered = Clock::now();
    if (!status) {
        noteError(status.error());
        return;
    }
    ++m_tally.believed;
    auto wrong = status->heartbeat == heartbeat ? m_truth.checkStatus(*status, asked, answered)
                                                : std::string("another heartbeat");
    if (!wrong.empty())
        m_tally.find(m_tally.wrong, "status: " + wrong);
    else if (const auto repeated = m_truth.checkCommands(*status); !repeated.empty())
        m_tally.find(m_tally.repeated, "status: " + repeated);
    m_program = {status->generation, status->activeCrc.value_or(0)};
    noteGoodStatus();
    if (m_download) {
        const auto step = m_download->noteStatus(*status);
        if (!step)
            endDownload(&step.error());
        else if (*step == modbus::Download::Phase::Active)
            endDownload(nullptr);
    }
}

void PanelMaster::readRegisters(std::uint16_t address, std::uint16_t count)
{
    const auto registers =
        timed("registers", 1, Slow::No, [&] { return m_client->readProven(address, count); });
    if (!registers) {
        noteError(registers.error());
        return;
    }
    ++m_tally.believed;
    // Another device's own values are true.
    if (address < CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT && m_faults.otherIdentity)
        return;
    if (const auto wrong = m_truth.checkRegisters(address, *registers); !wrong.empty())
        m_tally.find(m_tally.wrong, wrong);
}

void PanelMaster::readBankSlice()
{
    const auto size = static_cast<std::uint32_t>(m_truth.activeImage().size());
    const std::uint32_t offset = pick(size);
    const std::uint32_t count = 1 + pick(modbus::readbackRegisters);
    readRegisters(static_cast<std::uint16_t>(CTL_REG_ACTIVE + offset), static_cast<std::uint16_t>(count));
}

// Reads in pieces, like the panel: they belong together when the statuses before and after name the same
// program.
void PanelMaster::readWholeBank()
{
    const auto before = m_program;
    modbus::BankReader reader(CTL_REG_ACTIVE, static_cast<std::uint16_t>(m_truth.activeImage().size()));
    const int restarts = m_seen.restarts;
    while (m_client && !reader.complete()) {
        const auto piece = timed("bank", 1, Slow::No, [&] { return reader.advance(*m_client); });
        if (!piece)
            noteError(piece.error());
    }
    m_program.reset();
    while (m_client && !m_program)
        pollStatus();
    if (!reader.complete() || restarts != m_seen.restarts || m_program != before)
        return;
    ++m_tally.believed;
    if (const auto mixed = m_truth.checkBank(reader.registers()); !mixed.empty())
        m_tally.find(m_tally.mixed, mixed);
}

void PanelMaster::oneStep()
{
    connect();
    const std::uint32_t choice = pick(1000);
    if (m_download && choice < 500)
        stepDownload();
    else if (choice < 620)
        pollStatus();
    else if (choice < 740)
        readBankSlice();
    else if (choice < 790)
        readRegisters(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, 10);
    else if (choice < 830)
        readRegisters(static_cast<std::uint16_t>(pick(10)), static_cast<std::uint16_t>(1 + pick(9)));
    else if (choice < 880)
        writeParameter();
    else if (choice < 940)
        command(modbus::Command::Start);
    else if (choice < 960)
        command(pick(2) == 0 ? modbus::Command::CancelApply : modbus::Command::ResetFault);
    else if (choice < 980)
        command(modbus::Command::SetClock, {0, 0, 1'000'000 + pick(1'000'000)});
    else if (choice < 985)
        readWholeBank();
    else if (choice < 986 && m_faults.rules.find("restart") == std::string_view::npos)
        command(modbus::Command::SaveToFlash, {0, 0, m_truth.activeCrc()});
    else if (!m_download)
        startDownload();
    else
        pollStatus();
}

void PanelMaster::prepare()
{
    m_controller.setFaults("clear"); // accepted once it serves
    connect();
    const modbus::RegisterInfo& patience = modbus::registerNamed("parameter.heartbeat_timeout");
    const auto begun = Clock::now();
    while (!m_client->writeParameter(patience, patience.maximum)) {
        if (m_settings.time == ControllerTime::Steady || Clock::now() > begun + longestSearch)
            throw std::runtime_error("a clean line does not take a parameter");
    }
    pollStatus();
    while (!m_download)
        startDownload();
    while (m_download)
        stepDownload();
    readRegisters(CTL_REG_IDENTITY_DEVICE_TYPE, modbus::identityRegisters);
    readRegisters(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, 10);
    command(modbus::Command::SaveToFlash, {0, 0, m_truth.activeCrc()});
    pollStatus();
}

void PanelMaster::run(std::uint64_t exchanges)
{
    m_controller.setFaults(rulesFor(m_faults, m_settings, m_controller));
    m_isClean = false;
    const std::uint64_t until = m_tally.exchanges + exchanges;
    while (m_tally.exchanges < until)
        oneStep();
    m_isClean = true;
    m_tally.faults += m_controller.setFaults("clear");
    finish();
}

void PanelMaster::finish()
{
    constexpr milliseconds longestFinish{20'000};
    const auto begun = Clock::now();
    const std::uint64_t believed = m_tally.believed;
    // Includes late answers and returning ports, until three in a row are good.
    while (m_download || m_tally.believed < believed + 3) {
        if (Clock::now() > begun + m_settings.patience(longestFinish))
            throw std::runtime_error("a clean line does not work again");
        connect();
        if (m_download)
            stepDownload();
        if (m_client)
            pollStatus();
    }
    readWholeBank();
}

} // namespace campanel::soak
