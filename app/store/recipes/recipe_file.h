// SPDX-License-Identifier: Apache-2.0
// Recipes on disk. Writing replaces the file in one step, so that a power cut leaves the old or the new one.
// The previous copy remains beside it as FILE.bak.
#pragma once

#include "app/store/files/exchange_places.h"
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/signed_recipe.h"

#include <QDateTime>
#include <QMap>

namespace campanel::store {

[[nodiscard]] tl::expected<program::Recipe, FileError> readRecipe(const QString& path);

// Creates the folder when it is missing. After an error the file is unchanged.
[[nodiscard]] tl::expected<void, FileError> writeRecipe(const program::Recipe& recipe, const QString& path);

struct RecipeOffer {
    QString path;
    QString placeName;
    QDateTime changed;
    tl::expected<program::Recipe, FileError> recipe;
    std::optional<RecipeSignature> signature{}; // of a signed recipe that is valid
    bool isFromPlant = false;                   // `path` is the name of the offer
};

// A file that the plant's network offers.
struct ReceivedFile {
    QByteArray bytes;
    QDateTime received;
};

// Reads the offers of the plant's network, by their names. Those that are not signed are refused.
[[nodiscard]] QList<RecipeOffer> receivedRecipes(const QMap<QString, ReceivedFile>& files,
                                                 const QString& keyFolder);

// Returns the JSON files of the places, newest first. Signatures are checked with the keys in a folder. An
// offer of the kind NotShown tells what is missing. Waits for the disk.
[[nodiscard]] QList<RecipeOffer> offeredRecipes(const QList<Place>& places, const QString& keyFolder);

} // namespace campanel::store
