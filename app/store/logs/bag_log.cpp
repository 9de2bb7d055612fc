// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/bag_log.h"

#include "app/store/database/clock_mark.h"
#include "app/store/database/ring.h"
#include "app/store/logs/trend_bucket.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString bagTable = u"bag"_s;
constexpr qint64 spanGapMs = 60'000; // between the bags of one span

qint64 scaled(double value)
{
    return std::llround(value * thousandthsPerUnit);
}

QVariant scaled(const std::optional<double>& value)
{
    return value ? QVariant(scaled(*value)) : QVariant(QMetaType::fromType<qint64>());
}

std::optional<double> unscaled(const QVariant& value)
{
    return value.isNull() ? std::nullopt : std::optional(value.toDouble() / thousandthsPerUnit);
}

} // namespace

tl::expected<void, StoreError> BagLog::add(const QList<Bag>& bags)
{
    if (bags.isEmpty())
        return {};
    auto newest = newestMs();
    if (!newest)
        return tl::unexpected(newest.error());
    auto ring = Ring::begin(m_database, bagTable, u"time_ms"_s);
    if (!ring)
        return tl::unexpected(ring.error());
    qint64 askedMs = 0;
    qint64 givenMs = 0; // all times up to this one are taken
    for (Bag bag : bags) {
        if (isTimeDoubtful(bag.timeMs, *newest, bag.clock))
            bag.flags |= Bag::ClockNotSet;
        else if (bag.timeMs < *newest - maxSetBackMs) { // proven right
            if (const auto marked = markLater(bag.timeMs); !marked)
                return marked;
            newest = bag.timeMs;
        }
        if (!(bag.flags & Bag::ClockNotSet))
            newest = std::max(*newest, bag.timeMs);
        const auto program = programOf(bag);
        if (!program)
            return tl::unexpected(program.error());
        const auto inserted = insert(bag, *program, bag.timeMs == askedMs ? givenMs : bag.timeMs, *ring);
        if (!inserted)
            return tl::unexpected(inserted.error());
        if (bag.flags & Bag::ClockNotSet) {
            if (const auto noted = noteUnset(*inserted); !noted)
                return noted;
        }
        askedMs = bag.timeMs;
        givenMs = *inserted;
    }
    if (const auto kept = ring->end(bags.size(), m_kept); !kept)
        return kept;
    return forgetProgramsAndSpans();
}

tl::expected<qint64, StoreError> BagLog::newestMs()
{
    // From span to span: a clock may stay unset for millions of bags.
    qint64 beforeMs = std::numeric_limits<qint64>::max();
    while (true) {
        auto newest = m_database.execute(u"SELECT max(time_ms) FROM bag WHERE time_ms < ?"_s, {beforeMs});
        if (!newest)
            return tl::unexpected(newest.error());
        if (!newest->next() || newest->isNull(0))
            return 0;
        const qint64 timeMs = newest->value(0).toLongLong();
        auto span = m_database.execute(
            u"SELECT begin_ms FROM clock_unset WHERE begin_ms <= ? AND end_ms >= ? ORDER BY begin_ms LIMIT 1"_s,
            {timeMs, timeMs});
        if (!span)
            return tl::unexpected(span.error());
        if (!span->next())
            return timeMs;
        beforeMs = span->value(0).toLongLong();
    }
}

tl::expected<void, StoreError> BagLog::markLater(qint64 timeMs)
{
    for (
        const QString& statement :
        {u"UPDATE bag SET flags = flags | %1 WHERE time_ms > ?"_s.arg(Bag::ClockNotSet),
         u"INSERT OR REPLACE INTO clock_unset (begin_ms, end_ms) SELECT min(time_ms), max(time_ms) FROM bag WHERE time_ms > ?"_s}) {
        if (const auto done = m_database.execute(statement, {timeMs}); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

tl::expected<void, StoreError> BagLog::noteUnset(qint64 timeMs)
{
    const auto extended = m_database.execute(
        u"UPDATE clock_unset SET end_ms = max(end_ms, ?) WHERE begin_ms <= ? AND end_ms >= ?"_s,
        {timeMs, timeMs, timeMs - spanGapMs});
    if (!extended)
        return tl::unexpected(extended.error());
    if (extended->numRowsAffected() > 0)
        return {};
    const auto begun =
        m_database.execute(u"INSERT INTO clock_unset (begin_ms, end_ms) VALUES (?, ?)"_s, {timeMs, timeMs});
    return begun ? tl::expected<void, StoreError>() : tl::unexpected(begun.error());
}

tl::expected<qint64, StoreError> BagLog::programOf(const Bag& bag)
{
    auto noted =
        m_database.execute(uR"(INSERT INTO program (name, version, length_um, last_ms) VALUES (?, ?, ?, ?)
            ON CONFLICT (name, version, length_um) DO UPDATE SET last_ms = max(last_ms, excluded.last_ms)
            RETURNING id)"_s,
                           {bag.programName, bag.programVersion, scaled(bag.setLengthMm), bag.timeMs});
    if (!noted)
        return tl::unexpected(noted.error());
    if (!noted->next())
        return tl::unexpected(StoreError{StoreError::Kind::Failed, m_database.path(), {}});
    return noted->value(0).toLongLong();
}

tl::expected<qint64, StoreError> BagLog::insert(const Bag& bag, qint64 program, qint64 timeMs, Ring& ring)
{
    auto taken = m_database.execute(u"SELECT 1 FROM bag WHERE time_ms = ?"_s, {timeMs});
    if (!taken)
        return tl::unexpected(taken.error());
    if (taken->next()) {
        auto free = m_database.execute(uR"(SELECT time_ms + 1 FROM bag AS this WHERE time_ms >= ?
            AND NOT EXISTS (SELECT 1 FROM bag WHERE time_ms = this.time_ms + 1) ORDER BY time_ms LIMIT 1)"_s,
                                       {timeMs});
        if (!free)
            return tl::unexpected(free.error());
        timeMs = free->next() ? free->value(0).toLongLong() : timeMs;
    }
    const auto inserted =
        m_database.execute(u"INSERT INTO bag VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s,
                           {timeMs, program, scaled(bag.deviationMm), bag.lengths, scaled(bag.markErrorMm),
                            scaled(bag.followingErrorMm), scaled(bag.rateBagsPerMin),
                            static_cast<int>(bag.flags), ring.eraOf(timeMs)});
    if (!inserted)
        return tl::unexpected(inserted.error());
    return timeMs;
}

// Deletes programs and spans without bags.
tl::expected<void, StoreError> BagLog::forgetProgramsAndSpans()
{
    const auto done =
        m_database.execute(u"DELETE FROM program WHERE last_ms < (SELECT min(time_ms) FROM bag)"_s);
    if (!done)
        return tl::unexpected(done.error());
    const auto spans =
        m_database.execute(u"DELETE FROM clock_unset WHERE end_ms < (SELECT min(time_ms) FROM bag)"_s);
    return spans ? tl::expected<void, StoreError>() : tl::unexpected(spans.error());
}

tl::expected<qint64, StoreError> BagLog::count()
{
    return rowsOf(m_database, bagTable);
}

tl::expected<qint64, StoreError> BagLog::countBetween(qint64 fromMs, qint64 toMs, qint64 maxRows)
{
    auto counted = m_database.execute(
        u"SELECT count(*) FROM (SELECT 1 FROM bag WHERE time_ms >= ? AND time_ms < ? LIMIT ?)"_s,
        {fromMs, toMs, maxRows});
    if (!counted)
        return tl::unexpected(counted.error());
    return counted->next() ? counted->value(0).toLongLong() : 0;
}

tl::expected<bool, StoreError> BagLog::hasClockNotSet(qint64 fromMs, qint64 toMs)
{
    auto found = m_database.execute(u"SELECT 1 FROM clock_unset WHERE end_ms >= ? AND begin_ms < ? LIMIT 1"_s,
                                    {fromMs, toMs});
    if (!found)
        return tl::unexpected(found.error());
    return found->next();
}

tl::expected<void, StoreError> BagLog::forEach(qint64 fromMs, qint64 toMs,
                                               const std::function<void(const Bag&)>& take)
{
    auto rows =
        m_database.execute(uR"(SELECT time_ms, name, version, length_um, lengths, deviation_um, mark_error_um,
                   following_error_um, rate, flags
            FROM bag JOIN program ON program.id = bag.program
            WHERE time_ms >= ? AND time_ms < ? ORDER BY time_ms)"_s,
                           {fromMs, toMs});
    if (!rows)
        return tl::unexpected(rows.error());
    while (rows->next()) {
        Bag bag;
        bag.timeMs = rows->value(0).toLongLong();
        bag.programName = rows->value(1).toString();
        bag.programVersion = rows->value(2).toInt();
        bag.setLengthMm = rows->value(3).toDouble() / thousandthsPerUnit;
        bag.lengths = rows->value(4).toInt();
        bag.deviationMm = rows->value(5).toDouble() / thousandthsPerUnit;
        bag.markErrorMm = unscaled(rows->value(6));
        bag.followingErrorMm = unscaled(rows->value(7));
        bag.rateBagsPerMin = unscaled(rows->value(8));
        bag.flags = static_cast<quint8>(rows->value(9).toUInt());
        take(bag);
    }
    return m_database.stepped(*rows);
}

} // namespace campanel::store
