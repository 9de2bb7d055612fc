// SPDX-License-Identifier: Apache-2.0
// Exports the logs of the database as CSV, times in UTC.
#pragma once

#include "app/store/files/csv.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"

namespace campanel::store {

// Returns the rows in their order, with the hashes of the chain, for programs.
[[nodiscard]] QByteArray auditCsv(const QList<AuditRow>& rows);
[[nodiscard]] QByteArray alarmsCsv(const QList<AlarmRow>& rows);

struct AuditExport {
    QByteArray csv;
    bool isCut = false; // older rows are not in it
};

// Returns the newest `maxRows` rows of the filter as text, read by pages.
[[nodiscard]] tl::expected<AuditExport, StoreError> auditCsv(Database& database, const AuditFilter& filter,
                                                             qint64 maxRows, const CsvDialect& dialect);
[[nodiscard]] tl::expected<QByteArray, StoreError> alarmsCsv(Database& database, const LogFilter& filter,
                                                             const CsvDialect& dialect);

// Returns the rows from `sinceMs` (since 1970 UTC) on, newest first.
[[nodiscard]] tl::expected<QList<AuditRow>, StoreError> auditSince(Database& database, qint64 sinceMs);
[[nodiscard]] tl::expected<QList<AlarmRow>, StoreError> alarmsSince(Database& database, qint64 sinceMs);

} // namespace campanel::store
