// SPDX-License-Identifier: Apache-2.0
// A link without a line; see demo_link.h.
#include "app/main/demo_link.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {
namespace {

constexpr std::uint32_t firstBag = 12420;
constexpr int bagsShown = 60;
constexpr int samplesPerCycle = 78; // as over 115200 baud at one bag a second
constexpr int samplesPerBatch = 6;
constexpr double shareShown = 0.62; // of the newest cycle
constexpr double scatterMm = 0.09;
constexpr double lagS = 0.0012; // of the knife behind its target
constexpr unsigned seed = 7;
constexpr std::uint32_t generation = 12;

program::ProgramImage demoProgram()
{
    program::Recipe recipe;
    recipe.cutter().rateBagsPerMin = 60;
    recipe.cutter().bagLengthMm = 250;
    return *program::buildProgram(recipe);
}

modbus::Identity demoIdentity()
{
    modbus::Identity identity;
    identity.mapMajor = 1;
    identity.firmwareMajor = 1;
    identity.uniqueId = 1;
    identity.programKinds = 2;
    identity.rowCapacity = modbus::rowCapacity;
    identity.bankRegisters = modbus::bankRegisters;
    identity.timerClockHz = 8000000;
    identity.timerBits = 16;
    identity.maxPulseFrequencyHz = 500000;
    return identity;
}

} // namespace

DemoLink::DemoLink(QObject* parent)
    : Link(parent)
    , m_program(demoProgram())
{
}

void DemoLink::connectTo(const link::ConnectionSettings&)
{
    show(m_situation);
}

void DemoLink::request(const link::CommandRequest& request)
{
    if (request.command == modbus::Command::StopAtCycleEnd || request.command == modbus::Command::StopNow)
        ++m_stopRequests;
    link::CommandOutcome outcome;
    outcome.id = request.id;
    outcome.command = request.command;
    emit commandEnded(outcome);
}

void DemoLink::download(const std::vector<std::uint16_t>&)
{
    link::DownloadReport progress;
    progress.fraction = 0.4;
    emit downloadReported(progress);
}

void DemoLink::cancelDownload()
{
    link::DownloadReport canceled;
    canceled.stage = link::DownloadStage::Canceled;
    emit downloadReported(canceled);
}

void DemoLink::show(Situation situation)
{
    if (m_isShown && m_situation == situation)
        return;
    m_isShown = true;
    m_situation = situation;
    if (situation == Situation::Lost) {
        m_now += 4200ms;
        report(link::LinkState::Lost);
        return;
    }
    if (situation == Situation::Absent) {
        report(link::LinkState::Searching);
        return;
    }
    if (situation == Situation::Empty)
        emit reported({}); // another controller: what was known of the first one is forgotten
    report(link::LinkState::Connected);
    if (situation == Situation::Empty) {
        emit programRead({});
        modbus::StatusBlock idle;
        idle.state = modbus::State::Idle;
        emit statusReceived({{{m_now, idle}}, 0});
    } else {
        const auto& bank = m_program.registers;
        emit programRead(
            {generation, m_program.crc, {bank.begin(), bank.begin() + modbus::bankHeaderRegisters}});
        runBags();
    }
    report(link::LinkState::Connected); // the figures of the link are read again
}

void DemoLink::report(link::LinkState state)
{
    link::LinkReport report;
    report.state = state;
    report.portName = QStringLiteral("/dev/ttyUSB0");
    report.simulated = false;
    report.identity = demoIdentity();
    if (state == link::LinkState::Searching)
        report.error = modbus::LinkError{modbus::LinkErrorKind::PortAbsent, "/dev/ttyUSB0", {}, {}, 0};
    emit reported(report);
}

void DemoLink::runBags()
{
    std::mt19937 random(seed);
    std::normal_distribution<double> deviation(0.03, scatterMm);
    m_bags = firstBag;
    for (int bag = 0; bag <= bagsShown; ++bag) {
        const int samples =
            bag < bagsShown ? samplesPerCycle : static_cast<int>(shareShown * samplesPerCycle);
        const double off = std::round(100 * deviation(random)) / 100;
        link::StatusBatch batch;
        for (int i = 0; i < samples; ++i) {
            modbus::StatusBlock status = statusAt(static_cast<double>(i) / samplesPerCycle);
            status.cycleCount = status.bagCount = m_bags;
            status.bagDeviationMm = off;
            status.bagLengthMm = m_program.cutter().cycle.bagLengthMm + off;
            m_now += std::chrono::microseconds(1000000 / samplesPerCycle);
            batch.samples.append({m_now, status});
            if (batch.samples.size() == samplesPerBatch)
                emit statusReceived(std::exchange(batch, {}));
        }
        emit statusReceived(batch);
        ++m_bags;
    }
}

modbus::StatusBlock DemoLink::statusAt(double cycleShare) const
{
    const auto& cutter = m_program.cutter();
    const double pulsesPerMm = profile::pulsesPerMm(cutter.machine);
    const double timeS = cycleShare * cutter.cycle.cycleTimeS;
    const double lateS = std::fmod(timeS - lagS + cutter.cycle.cycleTimeS, cutter.cycle.cycleTimeS);
    const auto wanted = cutter.motion.at(timeS);
    const auto actual = cutter.motion.at(lateS);

    modbus::StatusBlock status;
    status.state = m_situation == Situation::Running ? modbus::State::Running
                   : m_situation == Situation::Fault ? modbus::State::Fault
                                                     : modbus::State::Ready;
    if (m_situation == Situation::Fault)
        status.faultBits = 1U << static_cast<unsigned>(modbus::FaultBit::FollowingError);
    status.programKind = modbus::ProgramKind::RotaryCutter;
    status.generation = generation;
    status.activeCrc = m_program.crc;
    status.savedCrc = m_program.crc;
    status.masterAngleDeg = 360 * cycleShare;
    if (m_situation == Situation::Running) {
        status.masterSpeedPercent = 100;
        status.commandedFrequencyHz = static_cast<std::int32_t>(wanted.velocityMmPerS * pulsesPerMm);
        status.actualFrequencyHz = static_cast<std::int32_t>(actual.velocityMmPerS * pulsesPerMm);
        status.followingErrorPulses = static_cast<std::int16_t>(wanted.velocityMmPerS * lagS * pulsesPerMm);
    }
    status.knifeAngleDeg = actual.positionMm / (2 * std::numbers::pi * cutter.machine.knifeRadiusMm) * 360;
    return status;
}

} // namespace campanel::panel
