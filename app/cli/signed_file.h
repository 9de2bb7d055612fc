// SPDX-License-Identifier: Apache-2.0
// A signed recipe file, checked.
#pragma once

#include "app/cli/failure.h"
#include "app/store/files/files.h"
#include "app/store/recipes/signed_recipe.h"

namespace campanel::cli {

// Reads the file and checks its signature with the keys of the people who are trusted.
[[nodiscard]] inline tl::expected<store::SignedRecipe, Failure>
readSignedRecipe(const QString& path, const QList<store::SignerKey>& keys)
{
    const auto bytes = store::readBytes(path);
    if (!bytes)
        return fail(bytes.error());
    if (!store::isSignedRecipe(*bytes))
        return fail(ExitCode::Refused, QStringLiteral("%1 is not signed.").arg(path));
    const auto valid = store::verifyRecipe(*bytes, path, keys);
    if (!valid)
        return fail(ExitCode::Refused, store::FileErrorText::describe(valid.error()));
    return *valid;
}

} // namespace campanel::cli
