// SPDX-License-Identifier: Apache-2.0
// Signed packages: who signed which version of CamPanel, when, and the SHA-256 of the file. The signature is
// a file of its own beside the package.
#pragma once

#include "app/store/recipes/recipe_keys.h"
#include "app/store/update/package_tools.h"

#include <tl/expected.hpp>

namespace campanel::store {

struct PackageSignature {
    PackageId package;
    qint64 bytes = 0;
    QByteArray sha256; // 32 bytes
    QString signer;
    qint64 signedMs = 0; // since 1970 UTC, whole seconds

    bool operator==(const PackageSignature&) const = default;
};

struct PackageFault {
    enum class Kind {
        NotReadable, // `detail` is the system's reason
        NotAPackage,
        NotSigned,
        UnknownSigner,   // `detail` is the signer
        WithdrawnSigner, // the same
        WrongSignature,  // the signature's file was changed, or another key signed it
        NewerSignature,  // a newer CamPanel has signed it
        Damaged,         // the file does not have the signed content
    };

    Kind kind = Kind::NotReadable;
    QString path;
    QString detail;

    bool operator==(const PackageFault&) const = default;
};

// Returns the path of the signature of a package.
[[nodiscard]] QString signaturePath(const QString& package);

// Reads the package and signs it. Waits for dpkg-deb.
[[nodiscard]] tl::expected<QByteArray, PackageFault> signPackage(const QString& path, qint64 signedMs,
                                                                 const SigningKey& key);
// Checks the signature beside the package, then reads the whole package and compares it.
[[nodiscard]] tl::expected<PackageSignature, PackageFault> verifyPackage(const QString& path,
                                                                         const QList<SignerKey>& keys);

} // namespace campanel::store
