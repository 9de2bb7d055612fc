// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/packing_line.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>
#include <cmath>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto shortestPeriod = 150ms;
// The maximum share of a slow line's time.
constexpr int shareOfTheLine = 5;
constexpr double mmPerUm = 0.001;

} // namespace

PackingLine::PackingLine(Controller& controller)
    : m_controller(controller)
    , m_sensor(controller.parameter("parameter.mark_distance"))
    , m_window(controller.parameter("parameter.mark_window"))
    , m_tracking(controller.parameter("parameter.mark_tracking"))
    , m_timer(this)
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &PackingLine::ask);
    connect(&controller.link(), &link::Link::registersRead, this, &PackingLine::takeRead);
    for (Parameter* parameter : setup())
        connect(parameter, &Parameter::changed, this, &PackingLine::changed);
    LanguageNotifier::follow(this);
}

bool PackingLine::recordsBags() const
{
    const auto& status = m_controller.status();
    // The first version of the map with these registers.
    constexpr std::uint16_t firstMinor = 2;
    return m_controller.isConnected() && m_controller.identity() &&
           m_controller.identity()->mapMinor >= firstMinor && status &&
           status->programKind == modbus::ProgramKind::RotaryCutter;
}

void PackingLine::noteConnection()
{
    if (!m_controller.isConnected())
        m_isAsked = false;
    if (!m_controller.identity())
        forget();
    askWhenIdle();
}

void PackingLine::noteProgram()
{
    for (Parameter* parameter : setup())
        parameter->doubt(); // its download may have written them
    askWhenIdle();
}

void PackingLine::askWhenIdle()
{
    if (!recordsBags()) {
        if (m_controller.isConnected() && m_status)
            forget();
        return;
    }
    readSetup();
    if (!m_isAsked && !m_timer.isActive())
        ask();
    emit changed();
}

void PackingLine::readSetup()
{
    for (Parameter* parameter : setup())
        parameter->readIfUncertain();
}

void PackingLine::forget()
{
    m_status.reset();
    m_controller.telemetry()->forget();
    m_film.reset();
    m_lastReportedBag.reset();
    emit changed();
}

void PackingLine::ask()
{
    if (m_wasFresh && !fresh()) {
        m_wasFresh = false;
        emit changed();
    }
    if (!recordsBags() || m_isAsked)
        return;
    readSetup();
    m_isAsked = true;
    m_askedAt = m_controller.now();
    m_controller.link().readRegisters({0, modbus::packerAddress, registers()});
}

std::uint16_t PackingLine::registers() const
{
    const auto& identity = m_controller.identity();
    return identity ? modbus::packerRegisters(identity->mapMinor) : std::uint16_t{0};
}

void PackingLine::takeRead(const link::ReadOutcome& outcome)
{
    if (outcome.request.address != modbus::packerAddress || outcome.request.count != registers())
        return;
    m_isAsked = false;
    const auto took = m_controller.now() - m_askedAt;
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(
        std::max<link::SteadyTime::duration>(shortestPeriod, shareOfTheLine * took)));
    if (outcome.end != link::ReadEnd::Done || outcome.registers.size() != outcome.request.count)
        return;
    m_status = modbus::decodePacker(outcome.registers);
    m_controller.telemetry()->take(modbus::packerAddress, outcome.registers);
    if (m_lastReportedBag.value_or(0) > m_status->bagNumber)
        m_film.reset(); // the controller was restarted
    m_film.note(static_cast<std::int32_t>(m_status->filmPositionUm));
    m_receivedAt = outcome.receivedAt;
    m_wasFresh = true;
    reportBags();
    emit changed();
}

// Reports the new bags. After a restart the controller counts from the start.
void PackingLine::reportBags()
{
    const bool hasRestarted = m_lastReportedBag && *m_lastReportedBag > m_status->bagNumber;
    const bool isFirst = !m_lastReportedBag || hasRestarted;
    const std::uint32_t lastReported = isFirst ? m_status->bagNumber : *m_lastReportedBag;
    m_lastReportedBag = m_status->bagNumber;
    if (!m_status->bags.empty() && m_status->bags.front().number > lastReported + 1 && !isFirst)
        emit bagsMissed();
    for (const modbus::BagRecord& bag : m_status->bags) {
        if (bag.number > lastReported)
            emit bagRecorded(bag);
    }
}

bool PackingLine::fresh() const
{
    return m_status && m_controller.now() - m_receivedAt < Controller::freshFor;
}

PackingLine::MarkState PackingLine::markState() const
{
    if (!m_status || !m_status->markState)
        return MarkState::Unknown;
    switch (*m_status->markState) {
    case modbus::MarkState::Off:
        return MarkState::Off;
    case modbus::MarkState::Searching:
        return MarkState::Searching;
    case modbus::MarkState::Aligning:
        return MarkState::Aligning;
    case modbus::MarkState::Tracking:
        return MarkState::Tracking;
    }
    return MarkState::Unknown;
}

QString PackingLine::lastSkipText() const
{
    return m_status ? ControllerSentences::text(m_status->lastSkip) : QString();
}

double PackingLine::teachPitchMm() const
{
    return m_status ? m_status->teachPitchMm.value_or(unknown) : unknown;
}

double PackingLine::teachScatterMm() const
{
    return m_status ? m_status->teachScatterMm.value_or(unknown) : unknown;
}

double PackingLine::filmTravelMm() const
{
    return m_status ? static_cast<double>(*m_film.value()) * mmPerUm : unknown;
}

double PackingLine::filmPositionMm() const
{
    return m_status ? m_status->filmPositionUm * mmPerUm : unknown;
}

double PackingLine::filmSpeedMmPerS() const
{
    const double speed = m_controller.active().bagLengthMm / m_controller.active().cycleSeconds *
                         m_controller.live().masterSpeedPercent / 100;
    const bool runs = m_status && m_status->filmGate == modbus::GateState::Running;
    return runs && std::isfinite(speed) ? speed : 0;
}

bool PackingLine::knifeOpen() const
{
    return m_status && m_status->knifeGate != modbus::GateState::Running;
}

// Returns the place one pitch behind the last mark that the sensor detected or should have detected.
double PackingLine::nextMarkMm() const
{
    const bool isExpected = markState() == MarkState::Aligning || markState() == MarkState::Tracking;
    if (!isExpected || m_status->seenMarks.empty())
        return unknown;
    const auto last = std::ranges::max_element(m_status->seenMarks, {}, &modbus::FilmMark::distanceMm);
    const double pitch =
        m_status->markPitchMm > 0 ? m_status->markPitchMm : m_controller.active().bagLengthMm;
    return last->distanceMm + pitch;
}

std::vector<program::FilmCut> PackingLine::nextCuts() const
{
    using Kind = program::FilmCut::Kind;
    std::vector<program::FilmCut> cuts;
    for (const modbus::FilmCut& cut : m_status ? m_status->cuts : std::vector<modbus::FilmCut>())
        cuts.push_back({cut.distanceMm, cut.isSkipped ? Kind::Skipped : Kind::Present});
    return cuts;
}

QList<QPointF> PackingLine::drawn(const std::vector<program::FilmCut>& cuts)
{
    QList<QPointF> points;
    for (const program::FilmCut& cut : cuts)
        points << QPointF(cut.distanceMm, static_cast<double>(cut.kind));
    return points;
}

QList<QPointF> PackingLine::seenMarks() const
{
    QList<QPointF> marks;
    for (const modbus::FilmMark& mark : m_status ? m_status->seenMarks : std::vector<modbus::FilmMark>())
        marks << QPointF(mark.distanceMm, mark.isReckoned ? 1 : 0);
    return marks;
}

QList<QPointF> PackingLine::seenProducts() const
{
    QList<QPointF> products;
    for (const modbus::FilmProduct& product :
         m_status ? m_status->seenProducts : std::vector<modbus::FilmProduct>())
        products << QPointF(product.leadMm, product.trailMm);
    return products;
}

void PackingLine::teach(int marks)
{
    if (m_controller.accessCheck().require(Level::Technician))
        m_controller.send(modbus::Command::TeachMarks, {static_cast<std::uint16_t>(marks), 0, 0});
}

} // namespace campanel::panel
