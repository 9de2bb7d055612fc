// SPDX-License-Identifier: Apache-2.0
// Keys named by options, and a signed recipe file, checked.
#pragma once

#include "app/cli/failure.h"
#include "app/cli/invocation.h"
#include "app/store/files/files.h"
#include "app/store/recipes/signed_recipe.h"

#include <QFileInfo>

namespace campanel::cli {

// Reads the secret key of --key.
[[nodiscard]] inline tl::expected<store::SigningKey, Failure> secretKeyOf(const Invocation& call)
{
    const QString path = call.value(QStringLiteral("key"));
    const auto bytes = store::readBytes(path);
    if (!bytes)
        return fail(ExitCode::File,
                    QStringLiteral("The key %1 cannot be read. Check its name and permissions.").arg(path));
    const auto key = store::secretKeyIn(*bytes);
    if (!key)
        return fail(ExitCode::File,
                    QStringLiteral("%1 is no secret key of CamPanel. Create one with new-key.").arg(path));
    return *key;
}

// Reads the public keys in the folder of --keys.
[[nodiscard]] inline tl::expected<QList<store::SignerKey>, Failure> publicKeysOf(const Invocation& call)
{
    const QString folder = call.value(QStringLiteral("keys"));
    if (!QFileInfo(folder).isDir())
        return fail(ExitCode::File,
                    QStringLiteral("%1 is no folder. Name the folder of the public keys.").arg(folder));
    return store::signerKeys(folder);
}

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
