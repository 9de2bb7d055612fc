// SPDX-License-Identifier: Apache-2.0
// Times are milliseconds since 1970 UTC.
#include "app/store/database/schema.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

const std::vector<QStringList>& migrations()
{
    static const std::vector<QStringList> steps{
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
            // Alarms: one row per occurrence, ids in their order; see AlarmRow. The indices contain only the
            // few open rows.
            uR"(CREATE TABLE alarm (
                    id INTEGER PRIMARY KEY,
                    code TEXT NOT NULL,
                    raised_ms INTEGER NOT NULL,
                    ending INTEGER NOT NULL,
                    returned_ms INTEGER,
                    wants_acknowledgement INTEGER NOT NULL,
                    acknowledged_ms INTEGER,
                    acknowledged_by TEXT NOT NULL,
                    count INTEGER NOT NULL,
                    shelved INTEGER NOT NULL,
                    detail TEXT NOT NULL))"_s,
            uR"(CREATE INDEX alarm_active ON alarm (ending) WHERE ending = 0)"_s,
            uR"(CREATE INDEX alarm_unacknowledged ON alarm (code, id)
                    WHERE acknowledged_ms IS NULL AND wants_acknowledgement = 1)"_s,
            uR"(CREATE TABLE alarm_shelf (
                    code TEXT PRIMARY KEY,
                    since_ms INTEGER NOT NULL,
                    until_ms INTEGER NOT NULL,
                    shelved_by TEXT NOT NULL) WITHOUT ROWID)"_s,
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
            uR"(CREATE TABLE audit (
                    sequence INTEGER PRIMARY KEY,
                    time_ms INTEGER NOT NULL,
                    who TEXT NOT NULL,
                    level INTEGER NOT NULL,
                    what TEXT NOT NULL,
                    object TEXT NOT NULL,
                    before TEXT NOT NULL,
                    after TEXT NOT NULL,
                    read_back TEXT NOT NULL,
                    outcome TEXT NOT NULL,
                    previous BLOB NOT NULL,
                    hash BLOB NOT NULL))"_s,
            u"CREATE TABLE audit_start (sequence INTEGER NOT NULL, hash BLOB NOT NULL)"_s,
        },
        {
            // The machine's states, and the reasons of its stops; see StateInterval. The id of a stop is that
            // of its first interval.
            uR"(CREATE TABLE state_interval (
                    id INTEGER PRIMARY KEY,
                    stop INTEGER NOT NULL,
                    state INTEGER NOT NULL,
                    begin_ms INTEGER NOT NULL,
                    duration_ms INTEGER NOT NULL,
                    program TEXT NOT NULL,
                    version INTEGER NOT NULL,
                    ideal_per_min REAL NOT NULL,
                    cycles INTEGER NOT NULL,
                    pieces INTEGER NOT NULL,
                    out_of_tolerance INTEGER NOT NULL,
                    start_up_scrap INTEGER NOT NULL,
                    skipped INTEGER NOT NULL))"_s,
            u"CREATE INDEX state_interval_begin ON state_interval (begin_ms)"_s,
            u"CREATE INDEX state_interval_stop ON state_interval (stop)"_s,
            uR"(CREATE TABLE stop (
                    id INTEGER PRIMARY KEY,
                    reason TEXT NOT NULL,
                    planned INTEGER NOT NULL,
                    answered_by TEXT NOT NULL,
                    answered_ms INTEGER NOT NULL))"_s,
        },
        {
            // The mark of rows that were written while the clock was not set, and the indices by which a span
            // of time is found.
            u"ALTER TABLE alarm ADD COLUMN clock_doubtful INTEGER NOT NULL DEFAULT 0"_s,
            u"ALTER TABLE audit ADD COLUMN clock_doubtful INTEGER NOT NULL DEFAULT 0"_s,
            u"CREATE INDEX alarm_raised ON alarm (raised_ms)"_s,
            u"CREATE INDEX audit_time ON audit (time_ms)"_s,
        },
        {
            // The same mark of states and versions of recipes.
            u"ALTER TABLE state_interval ADD COLUMN clock_doubtful INTEGER NOT NULL DEFAULT 0"_s,
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
    };
    return steps;
}

} // namespace campanel::store
