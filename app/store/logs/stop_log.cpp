// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/stop_log.h"

#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Written = tl::expected<void, StoreError>;

const QString intervalColumns =
    u"id, stop, state, begin_ms, duration_ms, program, version, ideal_per_min, cycles, pieces, "
    "out_of_tolerance, start_up_scrap, skipped, clock_doubtful"_s;

// Returns an empty text instead of a null string, which would be stored as NULL.
QString notNull(const QString& text)
{
    return text.isNull() ? u""_s : text;
}

Written writeInterval(Database& database, const StateInterval& interval)
{
    const auto done = database.execute(
        u"INSERT INTO state_interval (%1) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
        "ON CONFLICT (id) DO UPDATE SET duration_ms = excluded.duration_ms, cycles = excluded.cycles, "
        "pieces = excluded.pieces, out_of_tolerance = excluded.out_of_tolerance, "
        "start_up_scrap = excluded.start_up_scrap, skipped = excluded.skipped "
        "WHERE excluded.duration_ms >= state_interval.duration_ms"_s.arg(intervalColumns),
        {interval.id, interval.stop, static_cast<int>(interval.state), interval.beginMs, interval.durationMs,
         notNull(interval.program), interval.version, interval.idealPerMin, interval.cycles, interval.pieces,
         interval.outOfTolerance, interval.startUpScrap, interval.skipped, interval.isClockDoubtful});
    return done ? Written() : tl::unexpected(done.error());
}

Written writeStop(Database& database, const StopRow& stop)
{
    const auto done = database.execute(
        u"INSERT OR REPLACE INTO stop (id, reason, planned, answered_by, answered_ms) VALUES (?, ?, ?, ?, ?)"_s,
        {stop.id, notNull(stop.reason), stop.isPlanned, notNull(stop.by), stop.answeredMs});
    return done ? Written() : tl::unexpected(done.error());
}

Written forgetOldestIntervals(Database& database, qint64 capacity)
{
    const auto gone = database.execute(
        u"DELETE FROM state_interval WHERE id <= (SELECT max(id) FROM state_interval) - ?"_s, {capacity});
    if (!gone)
        return tl::unexpected(gone.error());
    if (gone->numRowsAffected() == 0)
        return {};
    const auto stops = database.execute(
        u"DELETE FROM stop WHERE id < (SELECT min(id) FROM state_interval) "
        "AND NOT EXISTS (SELECT 1 FROM state_interval WHERE state_interval.stop = stop.id)"_s);
    return stops ? Written() : tl::unexpected(stops.error());
}

StateInterval intervalOf(const QSqlQuery& query)
{
    StateInterval interval;
    interval.id = query.value(0).toLongLong();
    interval.stop = query.value(1).toLongLong();
    interval.state = static_cast<StateInterval::State>(query.value(2).toInt());
    interval.beginMs = query.value(3).toLongLong();
    interval.durationMs = query.value(4).toLongLong();
    interval.program = query.value(5).toString();
    interval.version = query.value(6).toInt();
    interval.idealPerMin = query.value(7).toDouble();
    interval.cycles = query.value(8).toLongLong();
    interval.pieces = query.value(9).toLongLong();
    interval.outOfTolerance = query.value(10).toLongLong();
    interval.startUpScrap = query.value(11).toLongLong();
    interval.skipped = query.value(12).toLongLong();
    interval.isClockDoubtful = query.value(13).toBool();
    return interval;
}

StopRow stopOf(const QSqlQuery& query)
{
    return {query.value(0).toLongLong(), query.value(1).toString(), query.value(2).toBool(),
            query.value(3).toString(), query.value(4).toLongLong()};
}

} // namespace

tl::expected<StopLog::Start, StoreError> StopLog::begin(Database& database)
{
    Start start;
    const auto newestMs = newestRecordMs(database);
    if (!newestMs)
        return tl::unexpected(newestMs.error());
    start.newestMs = *newestMs;
    auto newest =
        database.execute(u"SELECT %1 FROM state_interval ORDER BY id DESC LIMIT 1"_s.arg(intervalColumns));
    if (!newest)
        return tl::unexpected(newest.error());
    if (!newest->next())
        return start;
    start.last = intervalOf(*newest);
    newest->finish();
    const auto found = stop(database, start.last->stop);
    if (!found)
        return tl::unexpected(found.error());
    start.stop = *found;
    if (start.last->stop == 0)
        return start;
    auto whole =
        database.execute(u"SELECT begin_ms, sum(duration_ms), min(id) FROM state_interval WHERE stop = ?"_s,
                         {start.last->stop});
    if (!whole)
        return tl::unexpected(whole.error());
    if (whole->next()) {
        start.stopBeginMs = whole->value(0).toLongLong();
        start.stopMs = whole->value(1).toLongLong();
    }
    return start;
}

tl::expected<void, StoreError> StopLog::write(Database& database, const StopChanges& changes, qint64 capacity)
{
    return database.transaction([&]() -> Written {
        for (const StateInterval& interval : changes.intervals) {
            if (const Written done = writeInterval(database, interval); !done)
                return done;
        }
        for (const StopRow& stop : changes.stops) {
            if (const Written done = writeStop(database, stop); !done)
                return done;
        }
        return changes.intervals.isEmpty() ? Written() : forgetOldestIntervals(database, capacity);
    });
}

tl::expected<StopLog::Span, StoreError> StopLog::between(Database& database, qint64 fromMs, qint64 toMs)
{
    Span span;
    auto intervals = database.execute(
        u"SELECT %1 FROM state_interval WHERE begin_ms >= ? AND begin_ms < ? ORDER BY id"_s.arg(
            intervalColumns),
        {fromMs, toMs});
    if (!intervals)
        return tl::unexpected(intervals.error());
    while (intervals->next())
        span.intervals << intervalOf(*intervals);
    intervals->finish();
    auto stops = database.execute(
        u"SELECT id, reason, planned, answered_by, answered_ms FROM stop WHERE id IN "
        "(SELECT stop FROM state_interval WHERE begin_ms >= ? AND begin_ms < ?) ORDER BY id"_s,
        {fromMs, toMs});
    if (!stops)
        return tl::unexpected(stops.error());
    while (stops->next())
        span.stops << stopOf(*stops);
    return span;
}

tl::expected<std::optional<StopRow>, StoreError> StopLog::stop(Database& database, qint64 id)
{
    auto found = database.execute(
        u"SELECT id, reason, planned, answered_by, answered_ms FROM stop WHERE id = ?"_s, {id});
    if (!found)
        return tl::unexpected(found.error());
    return found->next() ? std::optional(stopOf(*found)) : std::nullopt;
}

} // namespace campanel::store
