// SPDX-License-Identifier: Apache-2.0
// Times are milliseconds since 1970 UTC.
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
        },
    };
    return steps;
}

} // namespace campanel::store
