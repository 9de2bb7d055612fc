// SPDX-License-Identifier: Apache-2.0
// Databases as an earlier version of the program made them.
#pragma once

#include "app/store/database/database.h"

namespace campanel::test {

// Returns a database file that stops at this version of its schema.
template <const store::DatabaseFile& (*file)(), int version> store::DatabaseFile earlierSchema()
{
    store::DatabaseFile earlier = file();
    earlier.complete = nullptr;
    earlier.steps = []() -> const std::vector<QStringList>& {
        static const std::vector<QStringList> steps(file().steps().begin(), file().steps().begin() + version);
        return steps;
    };
    return earlier;
}

// Takes the last steps of the main schema back, down to this version, which keeps the rows.
[[nodiscard]] inline bool goBackTo(store::Database& database, int version)
{
    using namespace Qt::StringLiterals;
    const auto dropColumn = [](const QString& table, const QString& column) {
        return u"ALTER TABLE %1 DROP COLUMN %2"_s.arg(table, column);
    };
    const QList<QStringList> undone{
        {dropColumn(u"production_order"_s, u"film_mm"_s)},
        {u"DROP TABLE production_order"_s},
        {u"DROP TABLE clock_proof"_s},
        {u"DROP INDEX recipe_name_key"_s, u"DROP INDEX user_name_key"_s,
         dropColumn(u"recipe"_s, u"name_key"_s), dropColumn(u"user"_s, u"name_key"_s)},
        {dropColumn(u"state_interval"_s, u"clock_doubtful"_s),
         dropColumn(u"recipe_version"_s, u"clock_doubtful"_s)},
        {u"DROP INDEX audit_time"_s, u"DROP INDEX alarm_raised"_s,
         dropColumn(u"audit"_s, u"clock_doubtful"_s), dropColumn(u"alarm"_s, u"clock_doubtful"_s)},
        {u"DROP TABLE state_interval"_s, u"DROP TABLE stop"_s}};
    bool isDone = true;
    for (int step = store::schemaVersion(); step > version; --step) {
        for (const QString& statement : undone.value(store::schemaVersion() - step))
            isDone = isDone && database.execute(statement).has_value();
    }
    return isDone && database.execute(u"PRAGMA user_version = %1"_s.arg(version)).has_value();
}

} // namespace campanel::test
