// SPDX-License-Identifier: Apache-2.0
// Times are milliseconds since 1970 UTC. Rings are tables whose rows have a slot as their key: a new row
// replaces the one that was written a whole ring before.
#include "app/store/schema.h"

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
            // One row for each time that an alarm came; went and acknowledged are empty until then.
            uR"(CREATE TABLE alarm (
                    id INTEGER PRIMARY KEY,
                    kind TEXT NOT NULL,
                    came_ms INTEGER NOT NULL,
                    went_ms INTEGER,
                    acknowledged_ms INTEGER,
                    acknowledged_by TEXT,
                    times INTEGER NOT NULL DEFAULT 1))"_s,
            u"CREATE INDEX alarm_came ON alarm (came_ms)"_s,
            u"CREATE INDEX alarm_open ON alarm (kind) WHERE went_ms IS NULL"_s,
            uR"(CREATE TABLE bag (
                    slot INTEGER PRIMARY KEY,
                    cut_ms INTEGER NOT NULL,
                    number INTEGER NOT NULL,
                    set_mm REAL NOT NULL,
                    lengths INTEGER NOT NULL,
                    deviation_mm REAL NOT NULL,
                    mark_error_mm REAL NOT NULL,
                    flags INTEGER NOT NULL))"_s,
            u"CREATE INDEX bag_cut ON bag (cut_ms)"_s,
            uR"(CREATE TABLE ring (name TEXT PRIMARY KEY, next INTEGER NOT NULL) WITHOUT ROWID)"_s,
        },
    };
    return steps;
}

} // namespace campanel::store
