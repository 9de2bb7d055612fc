// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/signed_recipe.h"

#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/signed_text.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const SignedForm recipeForm{u"campanel-signed-recipe"_s, u"recipe"_s, u"table_crc32"_s};

} // namespace

bool isSignedRecipe(const QByteArray& json)
{
    return isOfForm(recipeForm, json);
}

QByteArray signRecipe(const program::Recipe& recipe, qint64 signedMs, std::uint32_t tableCrc,
                      const SigningKey& key)
{
    return signText(recipeForm, QString::fromUtf8(toJson(recipe)),
                    u"%1"_s.arg(tableCrc, 8, 16, QLatin1Char('0')).toUpper(), signedMs, key);
}

tl::expected<SignedRecipe, FileError> verifyRecipe(const QByteArray& json, const QString& path,
                                                   const QList<SignerKey>& keys)
{
    const auto text = verifyText(recipeForm, json, path, keys);
    if (!text)
        return tl::unexpected(text.error());
    const auto recipe = fromJson(text->text.toUtf8(), path);
    if (!recipe)
        return tl::unexpected(recipe.error());
    return SignedRecipe{*recipe, {text->signer, text->signedMs(), text->mark.toUInt(nullptr, 16)}};
}

} // namespace campanel::store
