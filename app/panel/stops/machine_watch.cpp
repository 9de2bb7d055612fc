// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/machine_watch.h"

#include "app/panel/controller/controller.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/alarm_catalogue.h"
#include "app/program/solved_program.h"
#include "profile/cutter/limits.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::panel {

using store::StateInterval;

namespace {

static_assert(static_cast<int>(StateInterval::State::Fault) == static_cast<int>(modbus::State::Fault));

// Returns the code of the alarm that stopped the machine; empty: none.
QString alarmOf(const modbus::StatusBlock& status)
{
    const bool isFault = status.state == modbus::State::Fault;
    const auto set = isFault ? AlarmCatalogue::ofBits<modbus::FaultBit>(status.faultBits)
                             : AlarmCatalogue::ofBits<modbus::WarningBit>(status.warningBits);
    for (const AlarmKind& kind : AlarmCatalogue::all()) {
        if (kind.stopsMachine && set.contains(&kind))
            return kind.code();
    }
    return isFault ? AlarmCatalogue::unknownFault().code() : QString();
}

// Returns the fastest rate of a cutter on this machine; of other programs their own rate; 0: unknown.
double fastestPerMin(const ControllerProgram& program, const std::optional<profile::Machine>& machine)
{
    program::Recipe recipe = program.recipe;
    if (machine)
        recipe.machine = *machine;
    if (recipe.isCutter()) {
        const auto solved = program::solveProgram(recipe);
        const auto fastest = solved && solved->cutter ? profile::fastestRate(*solved->cutter) : std::nullopt;
        if (fastest)
            return fastest->rateBagsPerMin;
    }
    constexpr double secondsPerMinute = 60;
    return program.cycleSeconds > 0 ? secondsPerMinute / program.cycleSeconds : 0;
}

// Returns how far a count of the controller has come; 0 for the first one and after a restart.
qint64 advanceOf(std::optional<std::uint32_t>& last, std::uint32_t count)
{
    const std::optional before = std::exchange(last, count);
    return before && count > *before ? count - *before : 0;
}

} // namespace

MachineWatch::MachineWatch(Controller& controller, Settings& settings, DatabaseService& records,
                           StateBook& book)
    : m_controller(controller)
    , m_settings(settings)
    , m_records(records)
    , m_book(book)
    , m_clock(&QDateTime::currentMSecsSinceEpoch)
{
    // Connected after the controller, which handles the signal first.
    connect(&controller.link(), &link::Link::statusReceived, this, &MachineWatch::takeStatus);
    connect(controller.packing(), &PackingLine::bagRecorded, this, &MachineWatch::takeBag);
    connect(controller.packing(), &PackingLine::changed, this, &MachineWatch::takeSkippedCuts);
    // Pieces made during a gap are unknown.
    connect(&controller, &Controller::connectionChanged, this, [this] {
        if (m_controller.isConnected())
            return;
        m_pieces.reset();
        m_cutsSkipped.reset();
    });
}

StateBook::Now MachineWatch::now() const
{
    const qint64 utcMs = m_clock();
    return {m_controller.now(), utcMs, store::isTimeDoubtful(utcMs, m_newestMs, m_records.clockState())};
}

void MachineWatch::takeStatus()
{
    const auto& status = m_controller.status();
    if (!status || !status->state)
        return;
    const auto& program = m_controller.program();
    const bool isKnown = program && program->generation == status->generation;
    if (status->activeCrc && !isKnown)
        return; // its program is being read
    StateBook::Observation seen;
    seen.state = stateOf(*status);
    seen.cycles = status->cycleCount;
    seen.ownReason =
        seen.state == StateInterval::State::Suspended ? QString::fromLatin1(waitingReason) : alarmOf(*status);
    if (isKnown) {
        seen.program = QString::fromStdString(program->name);
        seen.version = std::isfinite(program->version) ? static_cast<int>(program->version) : 0;
        seen.idealPerMin = idealPerMin();
    }
    const StateBook::Now seenAt = now();
    if (!seenAt.isClockDoubtful)
        m_newestMs = std::max(m_newestMs, seenAt.utcMs);
    m_book.note(seen, seenAt);
    countPieces(*status);
    emit observed();
}

StateInterval::State MachineWatch::stateOf(const modbus::StatusBlock& status)
{
    const auto& line = m_controller.packing()->status();
    const bool waits = status.state == modbus::State::Running && m_controller.packing()->fresh() &&
                       line->filmGate == modbus::GateState::Standing;
    if (!waits)
        m_waitsSince.reset();
    else if (!m_waitsSince)
        m_waitsSince = m_controller.now();
    const bool isSuspended = m_waitsSince && m_controller.now() - *m_waitsSince >= suspendedAfter;
    return isSuspended ? StateInterval::State::Suspended : static_cast<StateInterval::State>(*status.state);
}

double MachineWatch::idealPerMin()
{
    const double set = m_settings.values().number("stops.ideal_rate");
    if (set > 0)
        return set;
    const auto& program = m_controller.program();
    const auto& machine = m_controller.torque()->machineData();
    if (program != m_program || machine != m_machineData) {
        m_program = program;
        m_machineData = machine;
        m_fastestPerMin = fastestPerMin(*program, machine);
    }
    return m_fastestPerMin;
}

// Counts what a controller does not record: bags of an older one, strokes, cycles.
void MachineWatch::countPieces(const modbus::StatusBlock& status)
{
    const bool isCutter = status.programKind == modbus::ProgramKind::RotaryCutter;
    const qint64 made = advanceOf(m_pieces, isCutter ? status.bagCount : status.cycleCount);
    if (made == 0 || m_controller.packing()->recordsBags())
        return;
    const bool isBadBag =
        isCutter && status.bagDeviationMm && std::abs(*status.bagDeviationMm) > m_settings.bagToleranceMm();
    const bool isBadStroke = status.press && status.press->result != modbus::StrokeResult::Ok &&
                             status.press->result != modbus::StrokeResult::None;
    m_book.add({made, isBadBag || isBadStroke ? 1 : 0, 0, 0});
}

void MachineWatch::takeBag(const modbus::BagRecord& bag)
{
    const bool isBad = !bag.isScrap() && std::abs(bag.deviationMm) > m_settings.bagToleranceMm();
    m_book.add({1, isBad ? 1 : 0, bag.isScrap() ? 1 : 0, 0});
}

void MachineWatch::takeSkippedCuts()
{
    const auto& line = m_controller.packing()->status();
    if (!line)
        return;
    if (const qint64 skipped = advanceOf(m_cutsSkipped, line->cutsSkipped); skipped > 0)
        m_book.add({0, 0, 0, skipped});
}

} // namespace campanel::panel
