// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/alarm_log.h"

#include "app/store/database/clock_mark.h"

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Done = tl::expected<void, StoreError>;

QVariant timeOrNull(qint64 ms)
{
    return ms > 0 ? QVariant(ms) : QVariant();
}

// Returns an empty text instead of a null string, which would be stored as NULL.
QString text(const QString& text)
{
    return text.isNull() ? u""_s : text;
}

Done writeRow(Database& database, const AlarmRow& row)
{
    const auto done = database.execute(
        u"INSERT INTO alarm (id, code, raised_ms, ending, returned_ms, wants_acknowledgement, "
        u"acknowledged_ms, "
        "acknowledged_by, count, shelved, detail, clock_doubtful) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?) "
        "ON CONFLICT (id) DO UPDATE SET ending = excluded.ending, returned_ms = excluded.returned_ms, "
        "wants_acknowledgement = excluded.wants_acknowledgement, acknowledged_ms = excluded.acknowledged_ms, "
        "acknowledged_by = excluded.acknowledged_by, count = excluded.count, shelved = excluded.shelved, "
        "detail = excluded.detail"_s,
        {row.id, row.code, row.raisedMs, static_cast<int>(row.end), timeOrNull(row.returnedMs),
         row.wantsAcknowledgement, timeOrNull(row.acknowledgedMs), text(row.acknowledgedBy), row.count,
         row.isShelved, text(row.detail.left(AlarmLog::detailLength)), row.isClockDoubtful});
    return done ? Done() : tl::unexpected(done.error());
}

Done acknowledge(Database& database, const AlarmChanges::Acknowledgement& given)
{
    const auto done = database.execute(
        u"UPDATE alarm SET acknowledged_ms = ?, acknowledged_by = ? WHERE code = ? AND id <= ? "
        "AND acknowledged_ms IS NULL AND wants_acknowledgement = 1"_s,
        {given.atMs, text(given.by), given.code, given.upToId});
    return done ? Done() : tl::unexpected(done.error());
}

Done writeShelves(Database& database, const QList<AlarmShelf>& shelves)
{
    if (const auto done = database.execute(u"DELETE FROM alarm_shelf"_s); !done)
        return tl::unexpected(done.error());
    for (const AlarmShelf& shelf : shelves) {
        const auto done = database.execute(u"INSERT INTO alarm_shelf VALUES (?, ?, ?, ?)"_s,
                                           {shelf.code, shelf.sinceMs, shelf.untilMs, text(shelf.by)});
        if (!done)
            return tl::unexpected(done.error());
    }
    return {};
}

Done forgetOldest(Database& database)
{
    const auto done = database.execute(u"DELETE FROM alarm WHERE id <= (SELECT max(id) FROM alarm) - ?"_s,
                                       {AlarmLog::capacity});
    return done ? Done() : tl::unexpected(done.error());
}

AlarmRow alarmRowOf(const QSqlQuery& query)
{
    AlarmRow row;
    row.id = query.value(0).toLongLong();
    row.code = query.value(1).toString();
    row.raisedMs = query.value(2).toLongLong();
    row.end = static_cast<AlarmRow::End>(query.value(3).toInt());
    row.returnedMs = query.value(4).toLongLong();
    row.wantsAcknowledgement = query.value(5).toBool();
    row.acknowledgedMs = query.value(6).toLongLong();
    row.acknowledgedBy = query.value(7).toString();
    row.count = query.value(8).toInt();
    row.isShelved = query.value(9).toBool();
    row.detail = query.value(10).toString();
    row.isClockDoubtful = query.value(11).toBool();
    return row;
}

} // namespace

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
    auto shelved = database.execute(u"SELECT code, since_ms, until_ms, shelved_by FROM alarm_shelf"_s);
    if (!shelved)
        return tl::unexpected(shelved.error());
    while (shelved->next())
        start.shelves.append({shelved->value(0).toString(), shelved->value(1).toLongLong(),
                              shelved->value(2).toLongLong(), shelved->value(3).toString()});
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

tl::expected<QList<AlarmRow>, StoreError> AlarmLog::page(Database& database, qint64 beforeId, int rows,
                                                         const LogFilter& filter)
{
    const auto range = rangeOf(database, filter, u"alarm"_s, u"id"_s, u"raised_ms"_s);
    if (!range)
        return tl::unexpected(range.error());
    const QString id = text(bareId(filter.id));
    const QString word = likePattern(filter.word);
    // The sign + keeps the order of the ids: the range was found by the index of times already.
    auto found = database.execute(
        u"SELECT id, code, raised_ms, ending, returned_ms, wants_acknowledgement, acknowledged_ms, "
        "acknowledged_by, count, shelved, detail, clock_doubtful FROM alarm "
        "WHERE id < ? AND id BETWEEN ? AND ? AND +raised_ms >= ? AND +raised_ms < ? "
        "AND (? = '' OR instr(replace(code, '-', ''), ?) > 0) "
        "AND (? = '' OR code IN (SELECT value FROM json_each(?)) OR detail LIKE ? ESCAPE '\\' "
        "OR acknowledged_by LIKE ? ESCAPE '\\') ORDER BY id DESC LIMIT ?"_s,
        {beforeId > 0 ? beforeId : std::numeric_limits<qint64>::max(), range->firstId, range->lastId,
         filter.fromMs, spanEndMs(filter), id, id, word, keysJson(filter), word, word, rows});
    if (!found)
        return tl::unexpected(found.error());
    QList<AlarmRow> page;
    while (found->next())
        page.append(alarmRowOf(*found));
    return page;
}

bool AlarmLog::includes(const LogFilter& filter, const AlarmRow& row)
{
    return filter.includesTime(row.raisedMs) && bareId(row.code).contains(bareId(filter.id)) &&
           filter.includesWord({row.code}, {row.detail, row.acknowledgedBy});
}

} // namespace campanel::store
