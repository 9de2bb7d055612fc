// SPDX-License-Identifier: Apache-2.0
// The tables of the main database, as the steps from each version to the next. A released step is never
// changed: a new one follows it. The tables of the logs come from their columns; see table.h. Times are
// milliseconds since 1970 UTC.
#include "app/store/database/names.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/order_log.h"
#include "app/store/logs/stop_log.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

std::vector<QStringList> stepsBesideTheLogs()
{
    return {
        {
            // The present versions are the highest of each recipe; a deleted recipe keeps its history.
            uR"(CREATE TABLE recipe (
                    id INTEGER PRIMARY KEY,
                    name TEXT NOT NULL UNIQUE COLLATE NOCASE,
                    deleted INTEGER NOT NULL DEFAULT 0))"_s,
            uR"(CREATE TABLE recipe_version (
                    recipe INTEGER NOT NULL REFERENCES recipe (id),
                    version INTEGER NOT NULL,
                    saved_ms INTEGER NOT NULL,
                    saved_by TEXT NOT NULL,
                    kind TEXT NOT NULL,
                    json BLOB NOT NULL,
                    PRIMARY KEY (recipe, version)) WITHOUT ROWID)"_s,
        },
        {
            // The machine data, one for each kind of program; separate from the recipes, which it outlives.
            uR"(CREATE TABLE machine_data (
                    kind TEXT PRIMARY KEY,
                    saved_ms INTEGER NOT NULL,
                    saved_by TEXT NOT NULL,
                    json BLOB NOT NULL) WITHOUT ROWID)"_s,
        },
        {
            // The tables of alarms. The indices contain only the few open rows.
            uR"(CREATE INDEX alarm_active ON alarm (ending) WHERE ending = 0)"_s,
            uR"(CREATE INDEX alarm_unacknowledged ON alarm (code, id)
                    WHERE acknowledged_ms IS NULL AND wants_acknowledgement = 1)"_s,
        },
        {
            // Users with their PINs, and the audit trail. A removed user stays as a name without a PIN.
            // audit_start has at most one row: the last deleted one of the trail.
            uR"(CREATE TABLE user (
                    id INTEGER PRIMARY KEY,
                    name TEXT NOT NULL COLLATE NOCASE,
                    level INTEGER NOT NULL,
                    pin TEXT NOT NULL,
                    failed INTEGER NOT NULL DEFAULT 0,
                    locked_until_ms INTEGER NOT NULL DEFAULT 0,
                    deleted INTEGER NOT NULL DEFAULT 0))"_s,
            u"CREATE UNIQUE INDEX user_name ON user (name) WHERE deleted = 0"_s,
            u"CREATE TABLE audit_start (sequence INTEGER NOT NULL, hash BLOB NOT NULL)"_s,
        },
        {
            // The tables of the machine's states and the reasons of its stops.
            u"CREATE INDEX state_interval_begin ON state_interval (begin_ms)"_s,
            u"CREATE INDEX state_interval_stop ON state_interval (stop)"_s,
        },
        {
            // The mark of rows that were written while the clock was not set, and the indices by which a span
            // of time is found.
            u"CREATE INDEX alarm_raised ON alarm (raised_ms)"_s,
            u"CREATE INDEX audit_time ON audit (time_ms)"_s,
        },
        {
            // The same mark of states and versions of recipes.
            u"ALTER TABLE recipe_version ADD COLUMN clock_doubtful INTEGER NOT NULL DEFAULT 0"_s,
        },
        {
            // The keys of the names, see names.h: SQLite compares the letters of ASCII alone without their
            // case.
            u"ALTER TABLE recipe ADD COLUMN name_key TEXT"_s,
            u"CREATE UNIQUE INDEX recipe_name_key ON recipe (name_key)"_s,
            u"ALTER TABLE user ADD COLUMN name_key TEXT"_s,
            u"CREATE UNIQUE INDEX user_name_key ON user (name_key) WHERE deleted = 0"_s,
        },
        {
            // At most one row: when the clock was last proven right, and the newest row of the audit trail
            // then.
            u"CREATE TABLE clock_proof (time_ms INTEGER NOT NULL, audit_sequence INTEGER NOT NULL)"_s,
        },
        {
            // The table of orders.
            u"CREATE INDEX production_order_started ON production_order (started_ms)"_s,
        },
    };
}

const std::vector<QStringList>& steps()
{
    static const std::vector<QStringList> all = [] {
        std::vector<QStringList> made = stepsBesideTheLogs();
        alarmTable().addSteps(made);
        alarmShelfTable().addSteps(made);
        auditTable().addSteps(made);
        stateTable().addSteps(made);
        stopTable().addSteps(made);
        orderTable().addSteps(made);
        return made;
    }();
    return all;
}

} // namespace

const DatabaseFile& mainDatabase()
{
    static const DatabaseFile file{u"campanel.sqlite"_s, &steps, true, &completeNames};
    return file;
}

int schemaVersion()
{
    return static_cast<int>(steps().size());
}

} // namespace campanel::store
