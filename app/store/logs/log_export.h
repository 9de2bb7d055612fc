// SPDX-License-Identifier: Apache-2.0
// The logs of the database as CSV (RFC 4180), times in UTC, for who works on with them elsewhere.
#pragma once

#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"

namespace campanel::store {

// In the order of the rows, with the hashes of the chain.
[[nodiscard]] QByteArray auditCsv(const QList<AuditRow>& rows);
[[nodiscard]] QByteArray alarmsCsv(const QList<AlarmRow>& rows);

// What happened at `sinceMs` (since 1970 UTC) or later, newest first.
[[nodiscard]] tl::expected<QList<AuditRow>, StoreError> auditSince(Database& database, qint64 sinceMs);
[[nodiscard]] tl::expected<QList<AlarmRow>, StoreError> alarmsSince(Database& database, qint64 sinceMs);

} // namespace campanel::store
