// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/alarm_log.h"

#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Done = tl::expected<void, StoreError>;

void csvEnd(CsvWriter& csv, const QVariant& value)
{
    const QStringList names{u"active"_s, u"returned"_s, u"unknown"_s};
    csv.text(names.value(value.toInt(), names.last()));
}

Done writeRow(Database& database, const AlarmRow& row)
{
    AlarmRow limited = row;
    limited.detail.truncate(AlarmLog::detailLength);
    return alarmTable().write(database, limited);
}

Done acknowledge(Database& database, const AlarmChanges::Acknowledgement& given)
{
    const auto done = database.execute(
        u"UPDATE alarm SET acknowledged_ms = ?, acknowledged_by = ? WHERE code = ? AND id <= ? "
        "AND acknowledged_ms IS NULL AND wants_acknowledgement = 1"_s,
        {given.atMs, given.by, given.code, given.upToId});
    return done ? Done() : tl::unexpected(done.error());
}

Done writeShelves(Database& database, const QList<AlarmShelf>& shelves)
{
    if (const auto done = database.execute(u"DELETE FROM alarm_shelf"_s); !done)
        return tl::unexpected(done.error());
    for (const AlarmShelf& shelf : shelves) {
        if (const Done done = alarmShelfTable().insert(database, shelf); !done)
            return done;
    }
    return {};
}

Done forgetOldest(Database& database)
{
    const auto done = database.execute(u"DELETE FROM alarm WHERE id <= (SELECT max(id) FROM alarm) - ?"_s,
                                       {AlarmLog::capacity});
    return done ? Done() : tl::unexpected(done.error());
}

} // namespace

const Table<AlarmRow>& alarmTable()
{
    using Row = AlarmRow;
    static const Table<Row> table{
        u"alarm"_s,
        3,
        {{.name = u"id"_s, .member = &Row::id},
         {.name = u"code"_s, .member = &Row::code, .sought = Sought::Code | Sought::Key, .isFinal = true},
         {.name = u"raised_ms"_s,
          .member = &Row::raisedMs,
          .heading = u"raised_utc"_s,
          .form = csvUtc,
          .sought = Sought::Time,
          .isFinal = true},
         {.name = u"ending"_s, .member = &Row::end, .heading = u"end"_s, .form = csvEnd},
         {.name = u"returned_ms"_s,
          .member = &Row::returnedMs,
          .heading = u"returned_utc"_s,
          .form = csvUtc,
          .isOptional = true},
         {.name = u"wants_acknowledgement"_s, .member = &Row::wantsAcknowledgement, .form = nullptr},
         {.name = u"acknowledged_ms"_s,
          .member = &Row::acknowledgedMs,
          .heading = u"acknowledged_utc"_s,
          .form = csvUtc,
          .isOptional = true},
         {.name = u"acknowledged_by"_s, .member = &Row::acknowledgedBy, .sought = Sought::Word},
         {.name = u"count"_s, .member = &Row::count},
         {.name = u"shelved"_s, .member = &Row::isShelved},
         {.name = u"detail"_s, .member = &Row::detail, .sought = Sought::Word},
         {.name = u"clock_doubtful"_s,
          .member = &Row::isClockDoubtful,
          .heading = u"clock"_s,
          .form = csvClock,
          .isFinal = true,
          .since = 6}}};
    return table;
}

const Table<AlarmShelf>& alarmShelfTable()
{
    using Row = AlarmShelf;
    static const Table<Row> table{u"alarm_shelf"_s,
                                  3,
                                  {{.name = u"code"_s, .member = &Row::code},
                                   {.name = u"since_ms"_s, .member = &Row::sinceMs},
                                   {.name = u"until_ms"_s, .member = &Row::untilMs},
                                   {.name = u"shelved_by"_s, .member = &Row::by}},
                                  u" WITHOUT ROWID"_s};
    return table;
}

tl::expected<AlarmLog::Start, StoreError> AlarmLog::begin(Database& database)
{
    static_assert(static_cast<int>(AlarmRow::End::Active) == 0 &&
                  static_cast<int>(AlarmRow::End::Unknown) == 2);
    // A literal instead of a bound value, so that the index of active alarms is used.
    if (const auto ended = database.execute(u"UPDATE alarm SET ending = 2 WHERE ending = 0"_s); !ended)
        return tl::unexpected(ended.error());
    auto last = database.execute(u"SELECT max(id) FROM alarm"_s);
    if (!last)
        return tl::unexpected(last.error());
    Start start;
    if (last->next())
        start.lastId = last->value(0).toLongLong();
    last->finish();
    const auto newest = newestRecordMs(database);
    if (!newest)
        return tl::unexpected(newest.error());
    start.newestMs = *newest;
    const auto shelves = alarmShelfTable().read(database);
    if (!shelves)
        return tl::unexpected(shelves.error());
    start.shelves = *shelves;
    const auto rows = alarmTable().read(
        database, u"WHERE acknowledged_ms IS NULL AND wants_acknowledgement = 1 ORDER BY id DESC LIMIT ?"_s,
        {maxUnacknowledged});
    if (!rows)
        return tl::unexpected(rows.error());
    start.unacknowledged = *rows;
    return start;
}

tl::expected<void, StoreError> AlarmLog::write(Database& database, const AlarmChanges& changes)
{
    return database.transaction([&]() -> Done {
        for (const AlarmRow& row : changes.rows) {
            if (const Done done = writeRow(database, row); !done)
                return done;
        }
        for (const auto& given : changes.acknowledgements) {
            if (const Done done = acknowledge(database, given); !done)
                return done;
        }
        if (changes.shelves) {
            if (const Done done = writeShelves(database, *changes.shelves); !done)
                return done;
        }
        return changes.rows.isEmpty() ? Done() : forgetOldest(database);
    });
}

} // namespace campanel::store
