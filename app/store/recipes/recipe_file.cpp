// SPDX-License-Identifier: Apache-2.0
// Keeps the previous copy only while it is a valid recipe.
#include "app/store/recipes/recipe_file.h"

#include "app/store/files/ask_places.h"
#include "app/store/files/files.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace campanel::store {

namespace {

// Reads a signed recipe into the offer.
void takeSigned(RecipeOffer& offer, const QByteArray& bytes, const QList<SignerKey>& keys)
{
    if (const auto valid = verifyRecipe(bytes, offer.path, keys)) {
        offer.recipe = valid->recipe;
        offer.signature = valid->signature;
    } else {
        offer.recipe = tl::unexpected(valid.error());
    }
}

RecipeOffer offeredRecipe(const QFileInfo& file, const Place& place, const QList<SignerKey>& keys)
{
    const QString path = file.filePath();
    RecipeOffer offer{path, place.name, file.lastModified(), tl::unexpected(FileError{})};
    const auto bytes = readBytes(path);
    if (!bytes)
        offer.recipe = tl::unexpected(bytes.error());
    else if (isSignedRecipe(*bytes))
        takeSigned(offer, *bytes, keys);
    else
        offer.recipe = fromJson(*bytes, path);
    return offer;
}

RecipeOffer missingOffers(const Place& place, const QString& notice)
{
    return {place.path,
            place.name,
            {},
            tl::unexpected(FileError{FileError::Kind::NotShown, place.path, {}, notice, {}, 0})};
}

RecipeOffer receivedRecipe(const QString& name, const ReceivedFile& file, const QList<SignerKey>& keys)
{
    RecipeOffer offer{name, FileErrorText::tr("Plant network"), file.received, tl::unexpected(FileError{})};
    offer.isFromPlant = true;
    const auto refuse = [&](FileError::Kind kind, const QString& found) {
        offer.recipe = tl::unexpected(FileError{kind, name, {}, found, {}, 0});
    };
    if (file.bytes.size() > maxFileBytes)
        refuse(FileError::Kind::NotReadable, FileErrorText::tooLarge());
    else if (isSignedRecipe(file.bytes))
        takeSigned(offer, file.bytes, keys);
    else if (const auto plain = fromJson(file.bytes, name))
        refuse(FileError::Kind::NotSigned, {});
    else
        offer.recipe = tl::unexpected(plain.error());
    return offer;
}

} // namespace

tl::expected<program::Recipe, FileError> readRecipe(const QString& path)
{
    return readBytes(path).and_then(
        [&path](const QByteArray& bytes) { return fromJson(bytes, path, Names::Repair); });
}

tl::expected<void, FileError> writeRecipe(const program::Recipe& recipe, const QString& path)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    // A damaged file must not replace the last good copy.
    if (const auto before = readBytes(path); before && fromJson(*before, path, Names::Repair)) {
        if (const auto kept = replaceBytes(backupPath(path), *before); !kept)
            return kept;
    }
    return replaceBytes(path, toJson(recipe));
}

QList<RecipeOffer> receivedRecipes(const QMap<QString, ReceivedFile>& files, const QString& keyFolder)
{
    const QList<SignerKey> keys = signerKeys(keyFolder);
    QList<RecipeOffer> offers;
    for (auto file = files.begin(); file != files.end(); ++file)
        offers << receivedRecipe(file.key(), file.value(), keys);
    return offers;
}

QList<RecipeOffer> offeredRecipes(const QList<Place>& places, const QString& keyFolder)
{
    constexpr qsizetype maxFiles = 2000;         // in one place
    constexpr std::chrono::seconds patience{20}; // a slow stick with many files
    const auto answers = askPlaces<QList<RecipeOffer>>(
        places,
        [keys = signerKeys(keyFolder)](const Place& place) {
            QList<RecipeOffer> offers;
            const FolderFiles found = filesIn(place, QStringLiteral("*.json"), maxFiles);
            for (const QFileInfo& file : found.files)
                offers << offeredRecipe(file, place, keys);
            if (!found.notice.isEmpty())
                offers << missingOffers(place, found.notice);
            return offers;
        },
        patience);
    QList<RecipeOffer> offers;
    for (qsizetype i = 0; i < places.size(); ++i) {
        const auto& answer = answers[static_cast<std::size_t>(i)];
        offers += answer ? *answer : QList{missingOffers(places[i], silentText(places[i]))};
    }
    std::ranges::stable_sort(offers, std::ranges::greater(), &RecipeOffer::changed);
    return offers;
}

} // namespace campanel::store
