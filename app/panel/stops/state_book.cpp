// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/state_book.h"

#include <cstdlib>
#include <utility>

namespace campanel::panel {

using store::StateInterval;
using store::StopRow;

namespace {

qint64 nextQuarter(qint64 utcMs)
{
    const qint64 rest = ((utcMs % StateBook::quarterMs) + StateBook::quarterMs) % StateBook::quarterMs;
    return utcMs - rest + StateBook::quarterMs;
}

qint64 msBetween(link::SteadyTime from, link::SteadyTime to)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(to - from).count();
}

bool isSuspended(StateInterval::State state)
{
    return state == StateInterval::State::Suspended;
}

} // namespace

void StateBook::begin(const store::StopLog::Start& start)
{
    m_isBegun = true;
    m_hadProgram = start.hadProgram;
    m_last = start.last;
    m_lastId = start.last ? start.last->id : 0;
    m_stop = start.stop.value_or(StopRow());
    m_stop.id = start.last ? start.last->stop : 0;
    m_stopMs = start.stopMs;
    m_stopBeginMs = start.stopBeginMs;
}

qint64 StateBook::msSinceBegin(link::SteadyTime steady) const
{
    return msBetween(m_openSince, steady);
}

void StateBook::check(const Now& now)
{
    if (m_open && msBetween(m_lastStatus, now.steady) > maxSilenceMs)
        close(msSinceBegin(m_lastStatus));
}

void StateBook::note(const Observation& seen, const Now& now)
{
    m_hadProgram = m_hadProgram || !seen.program.isEmpty();
    if (!m_isBegun || !m_hadProgram)
        return;
    check(now);
    m_isLastContinued = m_open.has_value();
    if (m_open)
        splitAtQuarters(now.steady);
    m_isClockDoubtful = now.isClockDoubtful;
    if (m_open) {
        const qint64 elapsedMs = msSinceBegin(now.steady);
        const bool hasJumped = std::abs(now.utcMs - m_open->beginMs - elapsedMs) > maxDriftMs;
        const bool isOther = seen.state != m_open->state || seen.program != m_open->program ||
                             seen.version != m_open->version || seen.idealPerMin != m_open->idealPerMin ||
                             now.isClockDoubtful != m_open->isClockDoubtful;
        if (hasJumped || isOther) {
            const qint64 beginMs = hasJumped ? now.utcMs : m_open->beginMs + elapsedMs;
            close(elapsedMs);
            open(seen, beginMs, now.steady);
        }
    } else {
        open(seen, now.utcMs, now.steady);
    }
    m_seen = seen;
    m_lastStatus = now.steady;
    m_open->durationMs = msSinceBegin(now.steady);
    m_open->cycles = seen.cycles;
    setOwnReason(seen, now);
}

// Time that has passed belongs to what was seen before.
void StateBook::splitAtQuarters(link::SteadyTime steady)
{
    for (qint64 quarter = nextQuarter(m_open->beginMs); m_open->beginMs + msSinceBegin(steady) >= quarter;
         quarter += quarterMs) {
        const qint64 lengthMs = quarter - m_open->beginMs;
        const link::SteadyTime since = m_openSince + std::chrono::milliseconds(lengthMs);
        close(lengthMs);
        open(m_seen, quarter, since);
    }
}

void StateBook::divide(const Now& now)
{
    if (!m_open)
        return;
    const qint64 elapsedMs = msSinceBegin(now.steady);
    const qint64 beginMs = m_open->beginMs + elapsedMs;
    close(elapsedMs);
    open(m_seen, beginMs, now.steady);
}

bool StateBook::continuesStop(const Observation& seen, qint64 beginMs) const
{
    if (!m_last || m_last->stop == 0 || isSuspended(m_last->state) != isSuspended(seen.state))
        return false;
    // After a gap only if the machine has not run meanwhile; a controller that was switched off counts anew.
    return m_isLastContinued ||
           (std::abs(beginMs - m_last->endMs()) <= maxGapMs && seen.cycles <= m_last->cycles);
}

void StateBook::open(const Observation& seen, qint64 beginMs, link::SteadyTime steady)
{
    StateInterval interval;
    interval.id = ++m_lastId;
    interval.state = seen.state;
    interval.beginMs = beginMs;
    interval.program = seen.program;
    interval.version = seen.version;
    interval.idealPerMin = seen.idealPerMin;
    interval.cycles = seen.cycles;
    interval.isClockDoubtful = m_isClockDoubtful;
    if (store::produces(seen.state)) {
        m_stop = {};
        m_stopMs = 0;
    } else if (continuesStop(seen, beginMs)) {
        interval.stop = m_last->stop;
    } else {
        interval.stop = interval.id;
        m_stop = {};
        m_stop.id = interval.id;
        m_stopMs = 0;
        m_stopBeginMs = beginMs;
    }
    m_open = interval;
    m_openSince = steady;
    m_isLastContinued = true;
    m_hasNews = true;
}

void StateBook::close(qint64 durationMs)
{
    m_open->durationMs = durationMs;
    if (m_open->stop != 0)
        m_stopMs += durationMs;
    if (durationMs > 0 || m_open->pieces > 0)
        keep(*m_open);
    m_last = std::exchange(m_open, std::nullopt);
    m_isLastContinued = true;
    m_hasNews = true;
}

void StateBook::setOwnReason(const Observation& seen, const Now& now)
{
    if (m_open->stop == 0 || seen.ownReason.isEmpty() || !m_stop.reason.isEmpty() || stopMs() > ownReasonMs)
        return;
    m_stop.reason = seen.ownReason;
    m_stop.answeredMs = now.utcMs;
    m_waitingStops[m_stop.id] = m_stop;
    m_hasNews = true;
}

void StateBook::add(const Pieces& pieces)
{
    StateInterval* interval = m_open ? &*m_open : m_last && m_isBegun ? &*m_last : nullptr;
    if (!interval)
        return;
    interval->pieces += pieces.pieces;
    interval->outOfTolerance += pieces.outOfTolerance;
    interval->startUpScrap += pieces.startUpScrap;
    interval->skipped += pieces.skipped;
    if (!m_open)
        keep(*interval);
}

bool StateBook::answer(const StopRow& answer)
{
    if (answer.id == 0 || answer.id != m_stop.id)
        return false;
    m_stop = answer;
    m_waitingStops[answer.id] = answer;
    m_hasNews = true;
    return true;
}

StopRow StateBook::presentStop() const
{
    return m_open && m_open->stop != 0 ? m_stop : StopRow();
}

qint64 StateBook::stopMs() const
{
    return m_open && m_open->stop != 0 ? m_stopMs + m_open->durationMs : 0;
}

void StateBook::keep(const StateInterval& interval)
{
    m_waiting[interval.id] = interval;
    if (m_waiting.size() > maxWaiting)
        m_waiting.erase(m_waiting.begin());
}

store::StopChanges StateBook::takeChanges()
{
    store::StopChanges changes;
    for (const auto& [id, interval] : std::exchange(m_waiting, {}))
        changes.intervals << interval;
    if (m_open)
        changes.intervals << *m_open;
    for (const auto& [id, stop] : std::exchange(m_waitingStops, {}))
        changes.stops << stop;
    m_hasNews = false;
    return changes;
}

void StateBook::putBack(const store::StopChanges& changes)
{
    for (const StateInterval& interval : changes.intervals) {
        if (!m_open || m_open->id != interval.id)
            m_waiting.emplace(interval.id, interval); // a newer one stays
    }
    for (const StopRow& stop : changes.stops)
        m_waitingStops.emplace(stop.id, stop.id == m_stop.id ? m_stop : stop);
    m_hasNews = m_hasNews || !changes.isEmpty();
}

} // namespace campanel::panel
