// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/run_statements.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>

namespace campanel::panel {

namespace {

constexpr double maxBagsAhead = 12; // more are not drawn

} // namespace

RunStatements::RunStatements(Controller& controller)
    : m_controller(controller)
{
    LanguageNotifier::follow(this);
    connect(this, &RunStatements::changed, this, &RunStatements::cutsChanged);
}

QString RunStatements::text(RunPlace place) const
{
    const auto found = row(place);
    return found ? RunSentences::text(*found) : QString();
}

QString RunStatements::film() const
{
    if (m_change && row(RunPlace::Film) == RunRow::FilmChanging)
        return ControllerSentences::changeUnderWay(m_change->price, m_change->film.toMm);
    return text(RunPlace::Film);
}

void RunStatements::announceChange(const program::ChangePrice& price, const program::ChangeFilm& film)
{
    m_change = Change{price, film, m_controller.status()->generation};
}

bool RunStatements::isArmed() const
{
    const auto& status = m_controller.status();
    return m_change && status && status->generation == m_change->generation &&
           status->stagedState == modbus::StagedState::Armed && m_facts.isMoving();
}

QList<QPointF> RunStatements::cuts() const
{
    const PackingLine& line = *m_controller.packing();
    if (!isArmed())
        return line.cuts();
    const double reachMm = maxBagsAhead * std::max(m_change->film.fromMm, m_change->film.toMm);
    return PackingLine::drawn(
        program::cutsOverChange(m_change->film, line.nextCuts(), line.filmSpeedMmPerS(), reachMm));
}

QString RunStatements::nextLength() const
{
    return isArmed() ? ControllerSentences::nextLength(m_change->film) : QString();
}

bool RunStatements::isAnnounced(const RunFacts& facts) const
{
    return m_change && m_controller.status()->generation == m_change->generation + 1 && !facts.hasBags;
}

RunFacts RunStatements::facts() const
{
    RunFacts facts;
    facts.isConnected = m_controller.isConnected() && m_controller.fresh();
    facts.program = m_controller.programState();
    facts.canStart = m_canStart;
    facts.isStartHeld = m_controller.startIsHeld();
    facts.hasBags = !m_controller.bagStatistics().deviationsMm().isEmpty();
    const PackingLine& line = *m_controller.packing();
    facts.areMarksWanted = line.marksWanted();
    if (line.status()) {
        facts.marks = line.status()->markState;
        facts.isFilmWaiting = line.status()->filmGate != modbus::GateState::Running;
        facts.isKnifeWaiting = line.status()->knifeGate != modbus::GateState::Running;
        facts.isThreading = line.status()->isThreading;
    }
    const auto& status = m_controller.status();
    if (facts.isConnected && status) {
        facts.state = status->state;
        facts.isChanging = status->stagedState == modbus::StagedState::Armed || isAnnounced(facts);
    }
    return facts;
}

int RunStatements::scrapOf(const RunFacts& facts) const
{
    if (!facts.isMoving())
        return 0;
    if (isAnnounced(facts))
        return std::max(0, m_change->price.maxScrap - m_controller.bagStatistics().scrap());
    const bool isOffMarks = facts.areMarksWanted && (facts.marks == modbus::MarkState::Searching ||
                                                     facts.marks == modbus::MarkState::Aligning);
    return isOffMarks ? 1 : 0;
}

void RunStatements::updateStart()
{
    m_canStart = m_controller.canStart();
    update();
}

void RunStatements::update()
{
    const auto& status = m_controller.status();
    if (m_change && (!status || status->generation > m_change->generation + 1))
        m_change.reset();
    const RunFacts now = facts();
    const int scrap = scrapOf(now);
    if (now == m_facts && scrap == m_scrapAhead)
        return;
    m_facts = now;
    m_scrapAhead = scrap;
    emit changed();
}

} // namespace campanel::panel
