// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

tl::expected<qint64, StoreError> newestRecordMs(Database& database)
{
    // A row of the trail counts when it was written after the proof and is later; the index of times finds
    // it.
    auto found = database.execute(
        uR"(WITH proof AS (SELECT coalesce(max(time_ms), 0) AS ms, coalesce(max(audit_sequence), 0) AS sequence
                FROM clock_proof)
            SELECT max(coalesce((SELECT raised_ms FROM alarm WHERE clock_doubtful = 0
                           ORDER BY raised_ms DESC LIMIT 1), 0),
                       coalesce((SELECT time_ms FROM audit, proof
                           WHERE clock_doubtful = 0 AND time_ms > proof.ms AND audit.sequence > proof.sequence
                           ORDER BY time_ms DESC LIMIT 1), 0),
                       (SELECT ms FROM proof)))"_s);
    if (!found)
        return tl::unexpected(found.error());
    return found->next() ? found->value(0).toLongLong() : 0;
}

tl::expected<void, StoreError> noteClockProven(Database& database, qint64 nowMs)
{
    return database.transaction([&]() -> tl::expected<void, StoreError> {
        for (const QString& statement : {
                 u"UPDATE alarm SET clock_doubtful = 1 WHERE raised_ms > ?"_s,
                 u"UPDATE state_interval SET clock_doubtful = 1 WHERE begin_ms > ?"_s,
                 u"UPDATE recipe_version SET clock_doubtful = 1 WHERE saved_ms > ?"_s,
                 u"UPDATE production_order SET clock_doubtful = 1 WHERE started_ms > ?"_s,
             }) {
            if (const auto done = database.execute(statement, {nowMs + maxSetBackMs}); !done)
                return tl::unexpected(done.error());
        }
        if (const auto done = database.execute(u"DELETE FROM clock_proof"_s); !done)
            return tl::unexpected(done.error());
        const auto kept = database.execute(u"INSERT INTO clock_proof (time_ms, audit_sequence) "
                                           "SELECT ?, coalesce(max(sequence), 0) FROM audit"_s,
                                           {nowMs});
        if (!kept)
            return tl::unexpected(kept.error());
        return {};
    });
}

} // namespace campanel::store
