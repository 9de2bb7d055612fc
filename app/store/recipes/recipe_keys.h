// SPDX-License-Identifier: Apache-2.0
// Keys of people who sign recipes and packages: Ed25519 by libsodium, each key in a JSON file of its own.
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

#include <tl/expected.hpp>

#include <optional>

namespace campanel::store {

// The secret key of a signer; it stays with the signer.
struct SigningKey {
    QString name;
    QByteArray secret; // 64 bytes
};

// The public key of a signer, which a panel trusts.
struct SignerKey {
    QString name;
    QByteArray publicKey; // 32 bytes
    bool isWithdrawn = false;
};

// Returns true for a name that a signature can carry: 1 to 64 visible characters.
[[nodiscard]] bool isSignerName(const QString& name);
// Creates a key from random numbers of the system; empty when there are none.
[[nodiscard]] std::optional<SigningKey> newSigningKey(const QString& name);

// Return the files of a key.
[[nodiscard]] QByteArray secretKeyFile(const SigningKey& key);
[[nodiscard]] QByteArray publicKeyFile(const SigningKey& key);
// Read a file of a key; the error says why it is none.
[[nodiscard]] std::optional<SigningKey> secretKeyIn(const QByteArray& file);
[[nodiscard]] tl::expected<SignerKey, QString> publicKeyIn(const QByteArray& file);

// Reads the public keys in a folder. A file that is no public key is logged with the reason and left out.
[[nodiscard]] QList<SignerKey> signerKeys(const QString& folder);

// Returns the signature of a text, 64 bytes.
[[nodiscard]] QByteArray signatureOf(const QByteArray& text, const SigningKey& key);
[[nodiscard]] bool isSignedBy(const SignerKey& key, const QByteArray& text, const QByteArray& signature);

enum class SignerTrust { Trusted, Unknown, Withdrawn, Wrong };

// Returns what the signature of a text by this signer is worth with these keys. A key that one of them
// withdraws is withdrawn.
[[nodiscard]] SignerTrust trustIn(const QByteArray& text, const QString& signer, const QByteArray& signature,
                                  const QList<SignerKey>& keys);

} // namespace campanel::store
