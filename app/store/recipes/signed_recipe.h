// SPDX-License-Identifier: Apache-2.0
// Signed recipes: the text of a recipe file, who signed it, when, and the CRC-32 of the table that the
// signer's machine runs. The signature covers all of it.
#pragma once

#include "app/program/recipe.h"
#include "app/store/files/file_error.h"
#include "app/store/recipes/recipe_keys.h"

#include <tl/expected.hpp>

namespace campanel::store {

struct RecipeSignature {
    QString signer;
    qint64 signedMs = 0;        // since 1970 UTC, whole seconds
    std::uint32_t tableCrc = 0; // on the machine data of the file
};

struct SignedRecipe {
    program::Recipe recipe;
    RecipeSignature signature;
};

// Returns true when the text claims to be a signed recipe.
[[nodiscard]] bool isSignedRecipe(const QByteArray& json);
[[nodiscard]] QByteArray signRecipe(const program::Recipe& recipe, qint64 signedMs, std::uint32_t tableCrc,
                                    const SigningKey& key);
// Reads a signed recipe and checks its signature before its content. `path` is only for the error. Errors of
// the signature: UnknownSigner, WithdrawnSigner, WrongSignature.
[[nodiscard]] tl::expected<SignedRecipe, FileError> verifyRecipe(const QByteArray& json, const QString& path,
                                                                 const QList<SignerKey>& keys);

} // namespace campanel::store
