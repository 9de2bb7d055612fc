// SPDX-License-Identifier: Apache-2.0
// The recipes of the panel: each under its name, all its versions, who saved them and when. A version is
// never changed; a recipe that is deleted keeps its versions. Everything here waits for the disk.
#pragma once

#include "app/program/recipe.h"
#include "app/store/database/database.h"

#include <QList>
#include <QString>

#include <tl/expected.hpp>

namespace campanel::store {

struct RecipeVersion {
    qint64 recipeId = 0;
    int version = 0;
    qint64 savedMs = 0; // since 1970, UTC
    QString savedBy;
    program::Recipe recipe; // under the recipe's present name
};

class RecipeLibrary {
public:
    explicit RecipeLibrary(Database& database)
        : m_database(database)
    {
    }

    template <typename Value> using Result = tl::expected<Value, StoreError>;

    // The newest version of each recipe that is not deleted, the one saved last first. What cannot be read
    // (it was written by a newer version of this program) is left out.
    [[nodiscard]] Result<QList<RecipeVersion>> newest();
    // All versions of one recipe, newest first.
    [[nodiscard]] Result<QList<RecipeVersion>> versions(qint64 recipeId);

    // Keeps it under its name (letters count alike in both cases) and says under which version: that of the
    // recipe, or the next one when that number is taken by another program. The same program again is no new
    // version. A deleted recipe of that name comes back.
    [[nodiscard]] Result<RecipeVersion> save(const program::Recipe& recipe, const QString& by, qint64 nowMs);

    // Errors: Refused when there is, or was, another recipe of that name.
    [[nodiscard]] Result<void> rename(qint64 recipeId, const QString& name);
    [[nodiscard]] Result<void> setDeleted(qint64 recipeId, bool isDeleted);

    // The data of the machine, one recipe for each kind that has been told; of these recipes only `machine`
    // and the kind count.
    [[nodiscard]] Result<QList<program::Recipe>> machines();
    [[nodiscard]] Result<void> saveMachine(const program::Recipe& recipe, const QString& by, qint64 nowMs);

private:
    Database& m_database;
};

} // namespace campanel::store
