// SPDX-License-Identifier: Apache-2.0
// Recipes on disk. Writing replaces the file in one step, so that a power cut leaves the old one or the new
// one; the copy before it stays beside it as FILE.bak.
#pragma once

#include "app/store/files/exchange_places.h"
#include "app/store/recipes/recipe_json.h"

#include <QDateTime>

namespace campanel::store {

[[nodiscard]] tl::expected<program::Recipe, FileError> readRecipe(const QString& path);

// Creates the folder when it is missing. On an error the file is as it was.
[[nodiscard]] tl::expected<void, FileError> writeRecipe(const program::Recipe& recipe, const QString& path);

// A file that can be looked at before anything is taken from it.
struct RecipeOffer {
    QString path;
    QString placeName;
    QDateTime changed;
    tl::expected<program::Recipe, FileError> recipe;
};

// The JSON files of the places, newest first. Waits for the disk.
[[nodiscard]] QList<RecipeOffer> offeredRecipes(const QList<Place>& places);

} // namespace campanel::store
