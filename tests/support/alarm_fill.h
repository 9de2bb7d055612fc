// SPDX-License-Identifier: Apache-2.0
// Fills the log of alarms inside the database: 100 000 rows take a fraction of a second.
#pragma once

#include "app/store/logs/alarm_log.h"

namespace campanel::test {

// Adds this many occurrences after the last one, ten seconds apart, each acknowledged and returned.
[[nodiscard]] inline bool fillAlarmLog(store::Database& database, int rows)
{
    return database
        .execute(QStringLiteral(
                     "WITH RECURSIVE n (i) AS (VALUES (1) UNION ALL SELECT i + 1 FROM n WHERE i < ?), "
                     "last (id) AS (SELECT coalesce(max(id), 0) FROM alarm) "
                     "INSERT INTO alarm (id, code, raised_ms, ending, returned_ms, wants_acknowledgement, "
                     "acknowledged_ms, acknowledged_by, count, shelved, detail) SELECT last.id + i, 'M-0' || "
                     "(1 + i % 5), 1700000000000 + 10000 * i, 1, "
                     "1700000000000 + 10000 * i + 4000, 1, 1700000000000 + 10000 * i + 9000, 'Wang', "
                     "1 + i % 7, 0, '' FROM n, last"),
                 {rows})
        .has_value();
}

} // namespace campanel::test
