// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/log_export.h"

#include <algorithm>
#include <optional>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

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

const QString auditHead =
    u"sequence,time_utc,who,level,what,object,before,after,read_back,outcome,previous,hash,clock"_s;
const QString alarmsHead =
    u"id,code,raised_utc,end,returned_utc,acknowledged_utc,acknowledged_by,count,shelved,detail,clock"_s;
constexpr int pageRows = 1000;

void addAudit(CsvWriter& csv, const QList<AuditRow>& rows)
{
    for (const AuditRow& row : rows) {
        const AuditEntry& entry = row.entry;
        csv.whole(row.sequence).utc(entry.timeMs).text(entry.who).whole(entry.level).text(entry.what);
        csv.text(entry.object).value(entry.before).value(entry.after).value(entry.readBack);
        csv.text(entry.outcome).text(QString::fromLatin1(row.previous.toHex()));
        csv.text(QString::fromLatin1(row.hash.toHex())).clock(entry.isClockDoubtful).endLine();
    }
}

void addAlarms(CsvWriter& csv, const QList<AlarmRow>& rows)
{
    for (const AlarmRow& row : rows) {
        csv.whole(row.id).text(row.code).utc(row.raisedMs).text(end(row.end)).utc(row.returnedMs);
        csv.utc(row.acknowledgedMs).text(row.acknowledgedBy).whole(row.count).yesOrNo(row.isShelved);
        csv.text(row.detail).clock(row.isClockDoubtful).endLine();
    }
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
    CsvWriter csv(auditHead, {});
    addAudit(csv, rows);
    return csv.bytes();
}

QByteArray alarmsCsv(const QList<AlarmRow>& rows)
{
    CsvWriter csv(alarmsHead, {});
    addAlarms(csv, rows);
    return csv.bytes();
}

tl::expected<AuditExport, StoreError> auditCsv(Database& database, const AuditFilter& filter, qint64 maxRows,
                                               const CsvDialect& dialect)
{
    CsvWriter csv(auditHead, dialect);
    qint64 left = maxRows;
    bool isCut = false;
    const auto done =
        forEachPage<AuditRow>([&](const auto& last) { return auditAfter(database, filter, last); },
                              [&](const QList<AuditRow>& page) {
                                  addAudit(csv, page.first(std::min(page.size(), left)));
                                  isCut = page.size() > left;
                                  left -= std::min(page.size(), left);
                                  return !isCut;
                              });
    return done ? tl::expected<AuditExport, StoreError>({csv.bytes(), isCut}) : tl::unexpected(done.error());
}

tl::expected<QByteArray, StoreError> alarmsCsv(Database& database, const LogFilter& filter,
                                               const CsvDialect& dialect)
{
    CsvWriter csv(alarmsHead, dialect);
    const auto done =
        forEachPage<AlarmRow>([&](const auto& last) { return alarmsAfter(database, filter, last); },
                              [&](const QList<AlarmRow>& page) {
                                  addAlarms(csv, page);
                                  return true;
                              });
    return done ? tl::expected<QByteArray, StoreError>(csv.bytes()) : tl::unexpected(done.error());
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
