// SPDX-License-Identifier: Apache-2.0
#include "app/store/users/pin_hash.h"

#include <QByteArray>

#include <sodium.h>

#include <array>

namespace campanel::store {

namespace {

// Twice libsodium's 64 MiB for logins: memory hinders parallel guessing more than passes do.
constexpr unsigned long long passes = crypto_pwhash_OPSLIMIT_INTERACTIVE;
constexpr std::size_t memoryBytes = std::size_t{128} << 20U;

bool isReady()
{
    static const bool ready = sodium_init() >= 0;
    return ready;
}

} // namespace

std::optional<QString> hashPin(const QString& pin)
{
    const QByteArray digits = pin.toUtf8();
    std::array<char, crypto_pwhash_STRBYTES> hash{};
    if (!isReady() ||
        crypto_pwhash_str_alg(hash.data(), digits.constData(), static_cast<unsigned long long>(digits.size()),
                              passes, memoryBytes, crypto_pwhash_ALG_ARGON2ID13) != 0)
        return std::nullopt;
    return QString::fromLatin1(hash.data());
}

bool isPin(const QString& hash, const QString& pin)
{
    const QByteArray digits = pin.toUtf8();
    const QByteArray kept = hash.toLatin1();
    return isReady() && crypto_pwhash_str_verify(kept.constData(), digits.constData(),
                                                 static_cast<unsigned long long>(digits.size())) == 0;
}

bool isPinHash(const QString& hash)
{
    return isReady() && crypto_pwhash_str_needs_rehash(hash.toLatin1().constData(), passes, memoryBytes) >= 0;
}

bool isOutdated(const QString& hash)
{
    return isReady() && crypto_pwhash_str_needs_rehash(hash.toLatin1().constData(), passes, memoryBytes) != 0;
}

} // namespace campanel::store
