// SPDX-License-Identifier: Apache-2.0
// Formats texts and times as fields of a CSV line (RFC 4180). All CSV files of CamPanel separate fields by
// commas and end every line with a line feed alone.
#pragma once

#include <QDateTime>
#include <QString>

namespace campanel::store {

// Adds quotation marks when they are necessary.
[[nodiscard]] inline QString csvField(const QString& text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r'))
        return text;
    QString doubled = text;
    return u'"' + doubled.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

// Returns a time since 1970 UTC as "2026-01-15T14:07:00.000Z".
[[nodiscard]] inline QString csvUtc(qint64 timeMs)
{
    return QDateTime::fromMSecsSinceEpoch(timeMs).toUTC().toString(Qt::ISODateWithMs);
}

// Returns two fields, UTC and local: "2026-01-15T14:07:00.000Z,2026-01-15T15:07:00.000+01:00".
[[nodiscard]] inline QString csvUtcAndLocal(qint64 timeMs)
{
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(timeMs);
    const QDateTime withOffset = local.toOffsetFromUtc(local.offsetFromUtc());
    return csvUtc(timeMs) + u',' + withOffset.toString(Qt::ISODateWithMs);
}

// Returns the field "clock" of a record.
[[nodiscard]] inline QString csvClock(bool isDoubtful)
{
    return isDoubtful ? QStringLiteral("not set") : QStringLiteral("set");
}

} // namespace campanel::store
