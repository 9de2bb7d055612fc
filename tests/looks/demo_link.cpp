// SPDX-License-Identifier: Apache-2.0
// A link without a line; see demo_link.h.
#include "tests/looks/demo_link.h"

#include "modbus/map/mark_edges.h"
#include "tests/looks/demo_line.h"
#include "tests/looks/demo_packing.h"
#include "tests/support/measure_image.h"
#include "tests/support/order_image.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::looks {
namespace {

constexpr std::uint32_t firstBag = 12420;
constexpr int bagsShown = 61;       // the first one was begun before the program and does not count
constexpr int samplesPerCycle = 78; // one bag a second at 115200 baud
constexpr int samplesPerBatch = 6;
constexpr int bagsInBatches = 2;    // newest bags, for the status rate of the last second
constexpr double shareShown = 0.62; // of the newest cycle, displayed share
constexpr double lagS = 0.0012;     // lag of the knife behind its target
constexpr unsigned strokeSeed = 7;
constexpr std::uint32_t firstGeneration = 12;
constexpr double samplesPerS = 78;
constexpr std::uint32_t freshUptimeS = 40;
constexpr std::uint32_t uptimeS = 18'000;
constexpr std::uint16_t everyBit = 0x01FF; // all faults and warnings that exist

constexpr std::uint32_t cyclesBefore = 1283; // for a move or a cam
constexpr std::uint32_t firstStroke = 4170;
constexpr int strokesShown = 24;
constexpr int badStroke = 21;
constexpr double stopForceN = 3900;
constexpr double weakForceN = 640;
constexpr double forceScatterN = 90;
constexpr double stopScatterMm = 0.006;
constexpr double frictionShare = 0.45; // share of the force before the part is seated

program::ProgramImage demoProgram(profile::ProgramKind kind)
{
    program::Recipe recipe = program::defaultRecipe(kind);
    switch (kind) {
    case profile::ProgramKind::RotaryCutter:
        recipe.cutter().rateBagsPerMin = 60;
        recipe.cutter().bagLengthMm = 250;
        break;
    case profile::ProgramKind::PositionMove:
        recipe.name = "Transfer";
        break;
    case profile::ProgramKind::SpeedMove:
        recipe.name = "Unwind";
        break;
    case profile::ProgramKind::PointCam:
        recipe.name = "Pusher";
        break;
    case profile::ProgramKind::Press:
        recipe.name = "Bearing 6204";
        break;
    case profile::ProgramKind::SegmentCam:
        recipe.name = "Gripper";
        break;
    }
    return *program::buildProgram(recipe);
}

std::uint32_t generationOf(profile::ProgramKind kind)
{
    return firstGeneration + static_cast<std::uint32_t>(kind);
}

// Returns the force at `share` of the way from contact to the stop: friction, then seating.
double pressForceN(double share, double touchForceN)
{
    const double friction =
        touchForceN + (frictionShare * stopForceN - touchForceN) * std::min(1.0, 1.4 * share);
    return friction + (1 - frictionShare) * stopForceN * std::pow(std::clamp(share, 0.0, 1.0), 12);
}

} // namespace

DemoLink::DemoLink(QObject* parent)
    : FakeLink(parent)
    , m_program(demoProgram(Kind::RotaryCutter))
{
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (modbus::isWrittenAlone(info))
            m_parameters[std::string(info.name)] = info.defaultValue;
    }
}

void DemoLink::connectTo(const link::ConnectionSettings&)
{
    show(m_situation);
}

void DemoLink::sendCommand(const link::CommandRequest& request)
{
    FakeLink::sendCommand(request);
    link::CommandOutcome outcome;
    outcome.id = request.id;
    outcome.command = request.command;
    emit commandEnded(outcome);
}

qsizetype DemoLink::stopRequests() const
{
    return std::ranges::count_if(requests, [](const link::CommandRequest& request) {
        return request.command == modbus::Command::StopAtCycleEnd ||
               request.command == modbus::Command::StopNow;
    });
}

void DemoLink::sendParameter(const link::ParameterRequest& request)
{
    if (request.value)
        m_parameters[request.name] = *request.value;
    const link::ParameterOutcome outcome{request.id, request.name, link::ParameterEnd::Done,
                                         m_parameters[request.name], std::nullopt};
    // Queued as on a line.
    QMetaObject::invokeMethod(
        this, [this, outcome] { emit parameterEnded(outcome); }, Qt::QueuedConnection);
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

void DemoLink::sendRead(const link::ReadRequest& request)
{
    if (request.address == modbus::packerAddress) {
        m_filmRequest = request;
        tellFilm();
        return;
    }
    if (request.address == modbus::sensorAddress && m_kind == Kind::RotaryCutter) {
        DemoFilm film;
        film.bagMm = m_program.cutter().cycle.bagLengthMm;
        film.bags = m_bags;
        emit registersRead({request, link::ReadEnd::Done, demoEdges(film), m_now, std::nullopt});
        return;
    }
    if (request.address == modbus::measureAddress) {
        emit registersRead(
            {request, link::ReadEnd::Done, test::measureRegisters(m_measure), m_now, std::nullopt});
        return;
    }
    if (request.address == modbus::orderStatusAddress) {
        emit registersRead(
            {request, link::ReadEnd::Done, test::orderRegisters(m_order), m_now, std::nullopt});
        return;
    }
    const auto registers =
        request.address == modbus::jamAddress
            ? demoJam(m_jamState, m_situation == Situation::Jammed)
            : demoRegisters(request, m_program, m_parameters["master_status.available"] == 1);
    emit registersRead({request, link::ReadEnd::Done, registers, m_now, std::nullopt});
}

void DemoLink::tellFilm()
{
    DemoFilm film;
    film.bagMm = m_program.cutter().cycle.bagLengthMm;
    film.cycleShare = m_cycleShare;
    film.bags = m_bags;
    film.trouble = m_situation == Situation::ProductAcross ? DemoFilm::Trouble::ProductAcross
                   : m_situation == Situation::MarksLost   ? DemoFilm::Trouble::MarksLost
                   : m_situation == Situation::Fresh       ? DemoFilm::Trouble::NotStarted
                                                           : DemoFilm::Trouble::None;
    if (m_filmRequest)
        emit registersRead({*m_filmRequest, link::ReadEnd::Done, demoPacker(film), m_now, std::nullopt});
}

void DemoLink::compareProgram(const std::vector<std::uint16_t>& /*bank*/)
{
    link::ComparisonReport equal;
    equal.stage = link::ComparisonStage::Equal;
    equal.fraction = 1;
    equal.generation = generationOf(m_kind);
    equal.expectedCrc = equal.controllerCrc = equal.readCrc = m_program.crc;
    emit comparisonReported(equal);
}

void DemoLink::simulateFaults(const QStringList& /*rules*/)
{
    emit faultsSimulated({});
}

void DemoLink::startScan(modbus::ScanPlan::Depth depth)
{
    m_isScanning = true;
    m_scanDepth = depth;
    reportScan(demoSearch(depth));
}

void DemoLink::cancelScan()
{
    if (!std::exchange(m_isScanning, false))
        return;
    link::ScanReport canceled;
    canceled.isCanceled = true;
    reportScan(canceled);
}

void DemoLink::endScan(bool isFound)
{
    m_isScanning = false;
    reportScan(demoSearchEnd(m_scanDepth, isFound, demoIdentity()));
}

void DemoLink::reportScan(const link::ScanReport& scan)
{
    report(m_isScanning || m_situation == Situation::Absent ? link::LinkState::Searching
                                                            : link::LinkState::Connected);
    emit scanReported(scan);
}

void DemoLink::watchFrames(bool isWatched)
{
    if (isWatched)
        emit framesRecorded(demoFrames(m_now));
}

void DemoLink::watchFigures(bool isWatched)
{
    if (isWatched)
        emit figuresReported(demoFigures(m_now));
}

void DemoLink::show(Situation situation, Kind kind)
{
    if (m_isShown && m_situation == situation && m_kind == kind)
        return;
    m_isShown = true;
    m_situation = situation;
    if (std::exchange(m_kind, kind) != kind)
        m_program = demoProgram(kind);
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
        emit reported({}); // another controller: the data of the first one is cleared
    report(link::LinkState::Connected);
    if (situation == Situation::Empty) {
        emit programRead({});
        modbus::StatusBlock idle;
        idle.state = modbus::State::Idle;
        emit statusReceived({{{m_now, idle}}, 0});
    } else {
        const auto& bank = m_program.registers;
        const std::vector<std::uint16_t> header(bank.begin(), bank.begin() + modbus::bankHeaderRegisters);
        const modbus::ListSpan span = modbus::listSpan(header);
        const auto list = bank.begin() + span.offset;
        pass(0, statusAt(0)); // the status causes the program to be read
        emit programRead({generationOf(m_kind), m_program.crc, header, {list, list + span.count}});
        runProgram();
    }
    report(link::LinkState::Connected); // the figures of the link are read again
}

void DemoLink::setSimulated(bool isSimulated)
{
    if (std::exchange(m_isSimulated, isSimulated) != isSimulated)
        report(m_situation == Situation::Lost     ? link::LinkState::Lost
               : m_situation == Situation::Absent ? link::LinkState::Searching
                                                  : link::LinkState::Connected);
}

void DemoLink::setLed(bool isLed)
{
    for (const char* name : {"master_status.available", "master.source"}) {
        if (std::exchange(m_parameters[name], isLed ? 1 : 0) != m_parameters[name])
            emit parameterEnded({0, name, link::ParameterEnd::Done, m_parameters[name], std::nullopt});
    }
}

void DemoLink::showWaitingStop()
{
    report(link::LinkState::Lost, modbus::Command::StopAtCycleEnd);
}

void DemoLink::report(link::LinkState state, std::optional<modbus::Command> pendingStop)
{
    link::LinkReport report;
    report.state = state;
    report.portName = QStringLiteral("/dev/ttyUSB0");
    report.simulated = m_isSimulated;
    report.simulator = m_isSimulated ? link::SimulatorState::Serving : link::SimulatorState::NotUsed;
    report.pendingStop = pendingStop;
    report.identity = demoIdentity();
    report.isScanning = m_isScanning;
    if (state == link::LinkState::Searching)
        report.error = modbus::LinkError{modbus::LinkErrorKind::PortAbsent, "/dev/ttyUSB0", {}, {}, 0};
    emit reported(report);
}

void DemoLink::runProgram()
{
    if (m_situation == Situation::Fresh && m_kind == Kind::RotaryCutter)
        tellFilm();
    if (m_situation == Situation::Fresh)
        pass(0, m_kind == Kind::Press ? strokeAt(0) : statusAt(0));
    else if (m_kind == Kind::RotaryCutter)
        runBags();
    else if (m_kind == Kind::Press)
        runStrokes();
    else
        runCycles();
}

void DemoLink::pass(double timeS, const modbus::StatusBlock& block)
{
    m_now += std::chrono::microseconds(std::llround(1e6 * timeS));
    emit statusReceived({{{m_now, block}}, 0});
}

void DemoLink::runBags()
{
    m_bags = firstBag;
    m_cycleShare = 0;
    tellFilm();
    for (int bag = 0; bag <= bagsShown; ++bag) {
        const int samples =
            bag < bagsShown ? samplesPerCycle : static_cast<int>(shareShown * samplesPerCycle);
        const double off = demoDeviationMm(m_bags);
        link::StatusBatch batch;
        for (int i = 0; i < samples; ++i) {
            modbus::StatusBlock block = statusAt(static_cast<double>(i) / samplesPerCycle);
            block.cycleCount = block.bagCount = m_bags;
            block.bagDeviationMm = off;
            block.bagLengthMm = m_program.cutter().cycle.bagLengthMm + off;
            m_now += std::chrono::microseconds(1000000 / samplesPerCycle);
            batch.samples.append({m_now, block});
            if (bag > bagsShown - bagsInBatches && batch.samples.size() == samplesPerBatch)
                emit statusReceived(std::exchange(batch, {}));
        }
        emit statusReceived(batch);
        if (bag == bagsShown)
            break;
        ++m_bags;
        tellFilm();
    }
    m_cycleShare = shareShown;
    tellFilm();
}

// Runs one whole cycle, so that the trace has an end, and the present one.
void DemoLink::runCycles()
{
    const double cycleS = m_program.solved.cycleS();
    const int samples = std::max(20, static_cast<int>(samplesPerS * cycleS));
    for (int i = 0; i < static_cast<int>((1 + shareShown) * samples); ++i) {
        modbus::StatusBlock block = statusAt(static_cast<double>(i % samples) / samples);
        block.cycleCount = cyclesBefore + static_cast<std::uint32_t>(i / samples);
        pass(cycleS / samples, block);
    }
}

// Runs the earlier strokes by their ends alone, then a complete one; while running it is displayed in its
// hold.
void DemoLink::runStrokes()
{
    std::mt19937 random(strokeSeed);
    std::normal_distribution<double> force(0, forceScatterN);
    std::normal_distribution<double> stopMm(0, stopScatterMm);
    const std::vector<double>& joints = m_program.solved.marksS;
    const double cycleS = m_program.solved.cycleS();
    modbus::PressStatus last;
    for (int stroke = 0; stroke <= strokesShown; ++stroke) {
        modbus::StatusBlock block = strokeAt(0);
        block.cycleCount = firstStroke + static_cast<std::uint32_t>(stroke);
        const bool isBad = stroke == badStroke;
        last.result = isBad ? modbus::StrokeResult::ForceTooLow : modbus::StrokeResult::Ok;
        last.stopForceN = static_cast<std::uint16_t>((isBad ? weakForceN : stopForceN) + force(random));
        last.peakForceN = last.stopForceN;
        last.stopErrorPulses = static_cast<std::int16_t>(stopMm(random) * m_program.solved.pulsesPerMm);
        last.stage = block.press->stage;
        block.press = last;
        pass(cycleS, block);
    }
    const double endS = isRunning() ? (joints[2] + joints[3]) / 2 : cycleS;
    for (double timeS = 1 / samplesPerS; timeS < endS; timeS += 1 / samplesPerS) {
        modbus::StatusBlock block = strokeAt(timeS);
        block.cycleCount = firstStroke + strokesShown;
        pass(1 / samplesPerS, block);
    }
    if (!isRunning()) {
        modbus::StatusBlock block = strokeAt(0);
        block.cycleCount = firstStroke + strokesShown;
        pass(1 / samplesPerS, block);
    }
}

modbus::StatusBlock DemoLink::strokeAt(double timeS) const
{
    const auto& press = std::get<profile::PressProgram>(m_program.recipe.program);
    const std::vector<double>& joints = m_program.solved.marksS;
    const auto motion = m_program.solved.motion.at(timeS);
    modbus::StatusBlock block = statusAt(timeS / m_program.solved.cycleS());
    block.masterAngleDeg.reset(); // a press has no master
    block.press.emplace();
    const auto stage = std::ranges::upper_bound(joints, timeS) - joints.begin();
    block.press->stage =
        timeS > 0 ? static_cast<modbus::PressStage>(stage + 1) : modbus::PressStage::Standing;
    const double touchMm = m_program.solved.motion.at(joints[1]).positionMm;
    const double share = (motion.positionMm - touchMm) / (press.pressPositionMm - touchMm);
    if (timeS > joints[1] && share > 0)
        block.press->forceN = static_cast<std::uint16_t>(pressForceN(share, press.probeForceN));
    return block;
}

bool DemoLink::isRunning() const
{
    return m_situation == Situation::Running || m_situation == Situation::ProductAcross;
}

modbus::Identity DemoLink::demoIdentity() const
{
    modbus::Identity identity = FakeLink::identity();
    identity.mapMinor = m_isOld ? std::uint16_t{0} : modbus::mapMinor;
    identity.firmwareMajor = 1;
    identity.uniqueId = 1;
    identity.maxPulseFrequencyHz = 500'000;
    return identity;
}

modbus::StatusBlock DemoLink::statusAt(double cycleShare) const
{
    const program::SolvedProgram& solved = m_program.solved;
    const double cycleS = solved.cycleS();
    const double timeS = cycleShare * cycleS;
    // A cutter and a cam continue from the previous cycle; a move and a stroke begin at rest.
    const bool repeats =
        m_kind == Kind::RotaryCutter || profile::camMaster(m_program.recipe.program) != nullptr;
    const double lateS = repeats ? std::fmod(timeS - lagS + cycleS, cycleS) : std::max(0.0, timeS - lagS);
    const auto wanted = solved.motion.at(timeS);
    const auto actual = solved.motion.at(lateS);

    modbus::StatusBlock block;
    const bool isFaulted = m_situation == Situation::Fault || m_situation == Situation::Jammed ||
                           m_situation == Situation::ManyAlarms;
    block.state = isRunning() ? modbus::State::Running
                  : isFaulted ? modbus::State::Fault
                              : modbus::State::Ready;
    if (m_situation == Situation::ManyAlarms) {
        block.faultBits = everyBit;
        block.warningBits = everyBit;
    }
    if (m_situation == Situation::Fault)
        block.faultBits = 1U << static_cast<unsigned>(modbus::FaultBit::FollowingError);
    if (m_situation == Situation::Jammed)
        block.faultBits = 1U << static_cast<unsigned>(modbus::FaultBit::Jam);
    if (m_situation == Situation::MarksLost)
        block.warningBits = 1U << static_cast<unsigned>(modbus::WarningBit::MarksLost);
    block.uptimeS = m_situation == Situation::Fresh ? freshUptimeS : uptimeS;
    block.programKind = static_cast<modbus::ProgramKind>(m_kind);
    block.generation = generationOf(m_kind);
    block.activeCrc = m_program.crc;
    block.savedCrc = m_program.crc;
    block.masterAngleDeg = 360 * cycleShare;
    if (isRunning()) {
        block.masterSpeedPercent = 100;
        block.commandedFrequencyHz = static_cast<std::int32_t>(wanted.velocityMmPerS * solved.pulsesPerMm);
        block.actualFrequencyHz = static_cast<std::int32_t>(actual.velocityMmPerS * solved.pulsesPerMm);
        block.followingErrorPulses =
            static_cast<std::int16_t>(wanted.velocityMmPerS * lagS * solved.pulsesPerMm);
    }
    block.axisPositionPulses = static_cast<std::int32_t>(actual.positionMm * solved.pulsesPerMm);
    if (solved.cutter)
        block.knifeAngleDeg = actual.positionMm / (2 * std::numbers::pi * solved.machine.knifeRadiusMm) * 360;
    return block;
}

} // namespace campanel::looks
