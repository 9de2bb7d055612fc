// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/log_export.h"

#include "app/store/files/csv.h"

#include <QDateTime>

#include <algorithm>
#include <optional>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

QString time(qint64 utcMs)
{
    return utcMs == 0 ? QString() : csvUtc(utcMs);
}

QByteArray line(QStringList fields)
{
    for (QString& field : fields)
        field = csvField(field);
    return fields.join(u',').toUtf8() + '\n';
}

QString end(AlarmRow::End end)
{
    switch (end) {
    case AlarmRow::End::Active:
        return u"active"_s;
    case AlarmRow::End::Returned:
        return u"returned"_s;
    case AlarmRow::End::Unknown:
        break;
    }
    return u"unknown"_s;
}

constexpr auto auditHead =
    "sequence,time_utc,who,level,what,object,before,after,read_back,outcome,previous,hash,clock\n";
constexpr auto alarmsHead =
    "id,code,raised_utc,end,returned_utc,acknowledged_utc,acknowledged_by,count,shelved,detail,clock\n";
constexpr int pageRows = 1000;

QByteArray auditLines(const QList<AuditRow>& rows)
{
    QByteArray text;
    for (const AuditRow& row : rows) {
        const AuditEntry& entry = row.entry;
        text += line({QString::number(row.sequence), time(entry.timeMs), entry.who,
                      QString::number(entry.level), entry.what, entry.object, entry.before, entry.after,
                      entry.readBack, entry.outcome, QString::fromLatin1(row.previous.toHex()),
                      QString::fromLatin1(row.hash.toHex()), csvClock(entry.isClockDoubtful)});
    }
    return text;
}

QByteArray alarmLines(const QList<AlarmRow>& rows)
{
    QByteArray text;
    for (const AlarmRow& row : rows) {
        text +=
            line({QString::number(row.id), row.code, time(row.raisedMs), end(row.end), time(row.returnedMs),
                  time(row.acknowledgedMs), row.acknowledgedBy, QString::number(row.count),
                  row.isShelved ? u"yes"_s : u"no"_s, row.detail, csvClock(row.isClockDoubtful)});
    }
    return text;
}

// Calls `use` with page after page from `read(last row)` until a page is empty or `use` returns false.
template <typename Row, typename Read, typename Use>
tl::expected<void, StoreError> forEachPage(Read read, Use use)
{
    std::optional<Row> last;
    while (true) {
        const tl::expected<QList<Row>, StoreError> page = read(last);
        if (!page)
            return tl::unexpected(page.error());
        if (page->isEmpty() || !use(*page))
            return {};
        last = page->last();
    }
}

tl::expected<QList<AuditRow>, StoreError> auditAfter(Database& database, const AuditFilter& filter,
                                                     const std::optional<AuditRow>& last)
{
    return readAudit(database, filter, last ? std::optional(last->sequence) : std::nullopt, pageRows);
}

tl::expected<QList<AlarmRow>, StoreError> alarmsAfter(Database& database, const LogFilter& filter,
                                                      const std::optional<AlarmRow>& last)
{
    return AlarmLog::page(database, last ? last->id : 0, pageRows, filter);
}

} // namespace

QByteArray auditCsv(const QList<AuditRow>& rows)
{
    return auditHead + auditLines(rows);
}

QByteArray alarmsCsv(const QList<AlarmRow>& rows)
{
    return alarmsHead + alarmLines(rows);
}

tl::expected<QByteArray, StoreError> auditCsv(Database& database, const AuditFilter& filter, qint64 maxRows)
{
    QByteArray text(auditHead);
    qint64 left = maxRows;
    const auto done =
        forEachPage<AuditRow>([&](const auto& last) { return auditAfter(database, filter, last); },
                              [&](const QList<AuditRow>& page) {
                                  text += auditLines(page.first(std::min(page.size(), left)));
                                  left -= std::min(page.size(), left);
                                  return left > 0;
                              });
    return done ? tl::expected<QByteArray, StoreError>(text) : tl::unexpected(done.error());
}

tl::expected<QByteArray, StoreError> alarmsCsv(Database& database, const LogFilter& filter)
{
    QByteArray text(alarmsHead);
    const auto done =
        forEachPage<AlarmRow>([&](const auto& last) { return alarmsAfter(database, filter, last); },
                              [&](const QList<AlarmRow>& page) {
                                  text += alarmLines(page);
                                  return true;
                              });
    return done ? tl::expected<QByteArray, StoreError>(text) : tl::unexpected(done.error());
}

tl::expected<QList<AuditRow>, StoreError> auditSince(Database& database, qint64 sinceMs)
{
    QList<AuditRow> rows;
    AuditFilter filter;
    filter.log.fromMs = sinceMs;
    const auto done =
        forEachPage<AuditRow>([&](const auto& last) { return auditAfter(database, filter, last); },
                              [&](const QList<AuditRow>& page) {
                                  rows += page;
                                  return true;
                              });
    return done ? tl::expected<QList<AuditRow>, StoreError>(rows) : tl::unexpected(done.error());
}

tl::expected<QList<AlarmRow>, StoreError> alarmsSince(Database& database, qint64 sinceMs)
{
    QList<AlarmRow> rows;
    LogFilter filter;
    filter.fromMs = sinceMs;
    const auto done =
        forEachPage<AlarmRow>([&](const auto& last) { return alarmsAfter(database, filter, last); },
                              [&](const QList<AlarmRow>& page) {
                                  rows += page;
                                  return true;
                              });
    return done ? tl::expected<QList<AlarmRow>, StoreError>(rows) : tl::unexpected(done.error());
}

} // namespace campanel::store
