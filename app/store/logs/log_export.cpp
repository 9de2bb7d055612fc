// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/log_export.h"

#include "app/store/files/csv.h"

#include <QDateTime>
#include <QTimeZone>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

QString time(qint64 utcMs)
{
    return utcMs == 0 ? QString()
                      : QDateTime::fromMSecsSinceEpoch(utcMs, QTimeZone::utc()).toString(Qt::ISODateWithMs);
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

// Collects all rows from that time on, by pages from `read`.
template <typename Row, typename Read, typename Time>
tl::expected<QList<Row>, StoreError> since(qint64 sinceMs, Read read, Time timeOf)
{
    QList<Row> all;
    while (true) {
        const tl::expected<QList<Row>, StoreError> page = read(all);
        if (!page)
            return tl::unexpected(page.error());
        for (const Row& row : *page) {
            if (timeOf(row) < sinceMs)
                return all;
            all << row;
        }
        if (page->isEmpty())
            return all;
    }
}

} // namespace

QByteArray auditCsv(const QList<AuditRow>& rows)
{
    QByteArray text("sequence,time_utc,who,level,what,object,before,after,read_back,outcome,previous,hash\n");
    for (const AuditRow& row : rows) {
        const AuditEntry& entry = row.entry;
        text +=
            line({QString::number(row.sequence), time(entry.timeMs), entry.who, QString::number(entry.level),
                  entry.what, entry.object, entry.before, entry.after, entry.readBack, entry.outcome,
                  QString::fromLatin1(row.previous.toHex()), QString::fromLatin1(row.hash.toHex())});
    }
    return text;
}

QByteArray alarmsCsv(const QList<AlarmRow>& rows)
{
    QByteArray text(
        "id,code,raised_utc,end,returned_utc,acknowledged_utc,acknowledged_by,count,shelved,detail\n");
    for (const AlarmRow& row : rows) {
        text += line({QString::number(row.id), row.code, time(row.raisedMs), end(row.end),
                      time(row.returnedMs), time(row.acknowledgedMs), row.acknowledgedBy,
                      QString::number(row.count), row.isShelved ? u"yes"_s : u"no"_s, row.detail});
    }
    return text;
}

tl::expected<QList<AuditRow>, StoreError> auditSince(Database& database, qint64 sinceMs)
{
    constexpr int page = 1000;
    return since<AuditRow>(
        sinceMs,
        [&](const QList<AuditRow>& read) {
            return readAudit(database, {},
                             read.isEmpty() ? std::nullopt : std::optional(read.last().sequence), page);
        },
        [](const AuditRow& row) { return row.entry.timeMs; });
}

tl::expected<QList<AlarmRow>, StoreError> alarmsSince(Database& database, qint64 sinceMs)
{
    return since<AlarmRow>(
        sinceMs,
        [&](const QList<AlarmRow>& read) {
            return AlarmLog::page(database, read.isEmpty() ? 0 : read.last().id);
        },
        [](const AlarmRow& row) { return row.raisedMs; });
}

} // namespace campanel::store
