// SPDX-License-Identifier: Apache-2.0
// The recipes of the panel by name, with all versions, their authors and times. A version is never changed; a
// deleted recipe keeps its versions. All functions wait for the disk.
#pragma once

#include "app/program/recipe.h"
#include "app/store/database/clock_mark.h"

#include <QHash>
#include <QList>
#include <QString>

#include <tl/expected.hpp>

namespace campanel::store {

struct RecipeVersion {
    qint64 recipeId = 0;
    int version = 0;
    qint64 savedMs = 0; // since 1970, UTC
    QString savedBy;
    program::Recipe recipe;       // with the recipe's present name
    bool isClockDoubtful = false; // saved while the clock was not set; see clock_mark.h
    int unreadableVersion = 0;    // a newer version of the recipe, which cannot be read; 0: none
};

// The machine for one kind of program; only `machine` and the kind of the recipe are valid.
struct MachineData {
    program::Recipe recipe;
    QString takenFrom; // the recipe that they were saved with when they themselves are lost; else empty
};

class RecipeLibrary {
public:
    explicit RecipeLibrary(Database& database)
        : m_database(database)
    {
    }

    template <typename Value> using Result = tl::expected<Value, StoreError>;

    // Returns the newest version of each recipe that can be read and is not deleted, the one saved last
    // first. Versions that cannot be read (damaged, or written by a newer version of this program) are
    // logged.
    [[nodiscard]] Result<QList<RecipeVersion>> newest();
    // Returns the names of the recipes that are not deleted and of which no version can be read.
    [[nodiscard]] Result<QStringList> unreadable();
    // Returns all versions of one recipe, newest first.
    [[nodiscard]] Result<QList<RecipeVersion>> versions(qint64 recipeId);

    // Returns the names of the recipes among the last changes in the audit trail, by their keys (see
    // names.h), each with the number of its last download: the higher, the later. A renamed recipe keeps its
    // number.
    [[nodiscard]] Result<QHash<QString, qint64>> downloads();

    // Returns true when there was never a recipe, not even one that was deleted.
    [[nodiscard]] Result<bool> isEmpty();

    // Returns true when the recipe's own version has this program and these codes, and is not deleted.
    [[nodiscard]] Result<bool> has(const program::Recipe& recipe);

    // Saves the recipe under its name (see names.h) and returns its version: that of the recipe, or the
    // next one when another program has that number. An unchanged program gets no new version. A deleted
    // recipe of that name is restored. The version is marked when the clock is not set, or cannot be right.
    // Errors: LastVersion when no number is left.
    [[nodiscard]] Result<RecipeVersion> save(const program::Recipe& recipe, const QString& by, qint64 nowMs,
                                             ClockState clock = ClockState::Unproven);

    // Renames a recipe. Errors: Refused when there is or was another recipe of that name.
    [[nodiscard]] Result<void> rename(qint64 recipeId, const QString& name);
    [[nodiscard]] Result<void> setDeleted(qint64 recipeId, bool isDeleted);

    // Returns the machine data of each kind that was set. When they cannot be read, those of the version of
    // this kind that was saved last take their place.
    [[nodiscard]] Result<QList<MachineData>> machines();
    // Saves the machine data of the recipe: always, or only when there are none of its kind.
    [[nodiscard]] Result<void> saveMachine(const program::Recipe& recipe, const QString& by, qint64 nowMs,
                                           bool replaces = true);

private:
    [[nodiscard]] Result<void> addOlder(QList<RecipeVersion>& found);
    [[nodiscard]] Result<qint64> idOf(const program::Recipe& recipe);
    [[nodiscard]] Result<int> highestVersion(qint64 recipeId);

    Database& m_database;
};

} // namespace campanel::store
