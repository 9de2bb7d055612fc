// SPDX-License-Identifier: Apache-2.0
#include "app/machine/packing_line.h"

#include "app/machine/controller_sentences.h"
#include "app/machine/machine.h"

#include <algorithm>
#include <cmath>

using namespace std::chrono_literals;

namespace campanel::machine {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr quint32 readId = 1; // of all that this object asks
constexpr auto shortestPeriod = 150ms;
constexpr auto freshFor = 1000ms;
// On a slow line: at most this share of its time.
constexpr int shareOfTheLine = 5;
constexpr double mmPerUm = 0.001;

} // namespace

PackingLine::PackingLine(Machine& machine)
    : m_machine(machine)
    , m_timer(this)
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &PackingLine::ask);
    connect(&machine.link(), &link::Link::registersRead, this, &PackingLine::takeRead);
}

bool PackingLine::isWanted() const
{
    const auto& status = m_machine.status();
    // A controller of an older map does not have these registers.
    constexpr std::uint16_t firstMinor = 2;
    return m_machine.isConnected() && m_machine.identity() && m_machine.identity()->mapMinor >= firstMinor &&
           status && status->programKind == modbus::ProgramKind::RotaryCutter;
}

void PackingLine::noteConnection()
{
    if (!m_machine.isConnected())
        m_isAsked = false;
    if (!m_machine.identity())
        forget();
    noteProgram();
}

void PackingLine::noteProgram()
{
    if (!isWanted()) {
        if (m_machine.isConnected() && m_status)
            forget();
        return;
    }
    if (!m_isAsked && !m_timer.isActive())
        ask();
}

void PackingLine::forget()
{
    m_status.reset();
    m_toldBag.reset();
    emit changed();
}

void PackingLine::ask()
{
    if (m_wasFresh && !fresh()) {
        m_wasFresh = false;
        emit changed();
    }
    if (!isWanted() || m_isAsked)
        return;
    m_isAsked = true;
    m_askedAt = m_machine.now();
    m_machine.link().readRegisters({readId, modbus::packerAddress, modbus::packerRegisters});
}

void PackingLine::takeRead(const link::ReadOutcome& outcome)
{
    if (outcome.request.id != readId || outcome.request.address != modbus::packerAddress)
        return;
    m_isAsked = false;
    const auto took = m_machine.now() - m_askedAt;
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(
        std::max<link::SteadyTime::duration>(shortestPeriod, shareOfTheLine * took)));
    if (outcome.end != link::ReadEnd::Done || outcome.registers.size() != modbus::packerRegisters)
        return;
    m_status = modbus::decodePacker(outcome.registers);
    m_receivedAt = outcome.receivedAt;
    m_wasFresh = true;
    tellBags();
    emit changed();
}

// Of a controller that has restarted the count begins anew.
void PackingLine::tellBags()
{
    const bool isFirst = !m_toldBag || *m_toldBag > m_status->bagNumber;
    const std::uint32_t told = isFirst ? m_status->bagNumber : *m_toldBag;
    m_toldBag = m_status->bagNumber;
    for (const modbus::BagRecord& bag : m_status->bags) {
        if (bag.number > told)
            emit bagRecorded(bag);
    }
}

bool PackingLine::fresh() const
{
    return m_status && m_machine.now() - m_receivedAt < freshFor;
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

QString PackingLine::markStateText() const
{
    return m_status && m_status->markState ? ControllerSentences::markState(*m_status->markState) : QString();
}

QString PackingLine::lastSkipText() const
{
    return m_status ? ControllerSentences::skipCause(m_status->lastSkip) : QString();
}

QString PackingLine::gateText() const
{
    if (!m_status)
        return {};
    if (m_status->filmGate != modbus::GateState::Running)
        return tr("Film waits for a product");
    if (m_status->knifeGate != modbus::GateState::Running)
        return tr("Knife stays open: product across");
    return {};
}

double PackingLine::teachPitchMm() const
{
    return m_status ? m_status->teachPitchMm.value_or(unknown) : unknown;
}

double PackingLine::teachScatterMm() const
{
    return m_status ? m_status->teachScatterMm.value_or(unknown) : unknown;
}

QVariant PackingLine::film() const
{
    if (!m_status)
        return {};
    FilmView view;
    view.at = m_receivedAt;
    view.filmMm = m_status->filmPositionUm * mmPerUm;
    const double bagMm = m_machine.activeBagLengthMm();
    const double cycleS = m_machine.cycleSeconds();
    const double speedShare = m_machine.masterSpeedPercent() / 100;
    view.bagMm = std::isfinite(bagMm) ? bagMm : 0;
    const double speed = bagMm / cycleS * speedShare;
    const bool runs = m_status->filmGate == modbus::GateState::Running;
    view.speedMmPerS = runs && std::isfinite(speed) ? speed : 0;
    view.cuts = m_status->cuts;
    view.marks = m_status->seenMarks;
    view.products = m_status->seenProducts;
    return QVariant::fromValue(view);
}

void PackingLine::teach(int marks)
{
    m_machine.send(modbus::Command::TeachMarks, {static_cast<std::uint16_t>(marks), 0, 0});
}

} // namespace campanel::machine
