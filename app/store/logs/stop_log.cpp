// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/stop_log.h"

#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Written = tl::expected<void, StoreError>;

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

} // namespace

const Table<StateInterval>& stateTable()
{
    using Row = StateInterval;
    static const Table<Row> table{
        u"state_interval"_s,
        5,
        {{.name = u"id"_s, .member = &Row::id},
         {.name = u"stop"_s, .member = &Row::stop, .isFinal = true},
         {.name = u"state"_s, .member = &Row::state, .isFinal = true},
         {.name = u"begin_ms"_s, .member = &Row::beginMs, .isFinal = true},
         {.name = u"duration_ms"_s, .member = &Row::durationMs},
         {.name = u"program"_s, .member = &Row::program, .isFinal = true},
         {.name = u"version"_s, .member = &Row::version, .isFinal = true},
         {.name = u"ideal_per_min"_s, .member = &Row::idealPerMin, .isFinal = true},
         {.name = u"cycles"_s, .member = &Row::cycles},
         {.name = u"pieces"_s, .member = &Row::pieces},
         {.name = u"out_of_tolerance"_s, .member = &Row::outOfTolerance},
         {.name = u"start_up_scrap"_s, .member = &Row::startUpScrap},
         {.name = u"skipped"_s, .member = &Row::skipped},
         {.name = u"clock_doubtful"_s, .member = &Row::isClockDoubtful, .isFinal = true, .since = 7}}};
    return table;
}

const Table<StopRow>& stopTable()
{
    using Row = StopRow;
    static const Table<Row> table{u"stop"_s,
                                  5,
                                  {{.name = u"id"_s, .member = &Row::id},
                                   {.name = u"reason"_s, .member = &Row::reason},
                                   {.name = u"planned"_s, .member = &Row::isPlanned},
                                   {.name = u"answered_by"_s, .member = &Row::by},
                                   {.name = u"answered_ms"_s, .member = &Row::answeredMs}}};
    return table;
}

tl::expected<StopLog::Start, StoreError> StopLog::begin(Database& database)
{
    Start start;
    const auto newestMs = newestRecordMs(database);
    if (!newestMs)
        return tl::unexpected(newestMs.error());
    start.newestMs = *newestMs;
    const auto newest = stateTable().read(database, u"ORDER BY id DESC LIMIT 1"_s);
    if (!newest)
        return tl::unexpected(newest.error());
    if (newest->isEmpty())
        return start;
    start.last = newest->first();
    auto programs = database.execute(u"SELECT 1 FROM state_interval WHERE program <> '' LIMIT 1"_s);
    if (!programs)
        return tl::unexpected(programs.error());
    start.hadProgram = programs->next();
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
            const Written done = stateTable().write(
                database, interval, u"WHERE excluded.duration_ms >= state_interval.duration_ms"_s);
            if (!done)
                return done;
        }
        for (const StopRow& stop : changes.stops) {
            if (const Written done = stopTable().write(database, stop); !done)
                return done;
        }
        return changes.intervals.isEmpty() ? Written() : forgetOldestIntervals(database, capacity);
    });
}

tl::expected<StopLog::Span, StoreError> StopLog::between(Database& database, qint64 fromMs, qint64 toMs)
{
    const auto intervals =
        stateTable().read(database, u"WHERE begin_ms >= ? AND begin_ms < ? ORDER BY id"_s, {fromMs, toMs});
    if (!intervals)
        return tl::unexpected(intervals.error());
    const auto stops = stopTable().read(
        database,
        u"WHERE id IN (SELECT stop FROM state_interval WHERE begin_ms >= ? AND begin_ms < ?) ORDER BY id"_s,
        {fromMs, toMs});
    if (!stops)
        return tl::unexpected(stops.error());
    return Span{*intervals, *stops};
}

tl::expected<std::optional<StopRow>, StoreError> StopLog::stop(Database& database, qint64 id)
{
    return stopTable().read(database, u"WHERE id = ?"_s, {id}).map([](const QList<StopRow>& found) {
        return found.isEmpty() ? std::nullopt : std::optional(found.first());
    });
}

} // namespace campanel::store
