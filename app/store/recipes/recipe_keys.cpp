// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/recipe_keys.h"

#include "app/store/database/names.h"
#include "app/store/files/files.h"
#include "app/store/files/json_keys.h"
#include "app/store/files/store_logging.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <sodium.h>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString secretFormat = u"campanel-secret-key"_s;
const QString publicFormat = u"campanel-public-key"_s;

const unsigned char* bytesOf(const QByteArray& bytes)
{
    return reinterpret_cast<const unsigned char*>(bytes.constData());
}

unsigned char* bytesOf(QByteArray& bytes)
{
    return reinterpret_cast<unsigned char*>(bytes.data());
}

QByteArray keyFile(const QString& format, const QString& name, const QByteArray& key)
{
    return QJsonDocument(QJsonObject{{u"format"_s, format},
                                     {u"name"_s, name},
                                     {u"key"_s, QString::fromLatin1(key.toBase64())}})
        .toJson();
}

struct KeyInFile {
    QString name;
    QByteArray key;
    bool isWithdrawn = false;
};

// Reads a key, or returns why the file is none. A key that is unknown or occurs twice may be a "withdrawn"
// that was misspelled: such a file is no key.
tl::expected<KeyInFile, QString> keyIn(const QByteArray& file, const QString& format, qsizetype size)
{
    const QJsonDocument document = QJsonDocument::fromJson(file);
    if (!document.isObject())
        return tl::unexpected(u"it is not JSON"_s);
    if (const auto key = repeatedKey(file))
        return tl::unexpected(u"it has \"%1\" twice"_s.arg(*key));
    const QJsonObject root = document.object();
    for (const QString& key : root.keys()) {
        if (!QStringList{u"format"_s, u"name"_s, u"key"_s, u"withdrawn"_s}.contains(key))
            return tl::unexpected(u"\"%1\" is unknown"_s.arg(key));
    }
    const auto key = QByteArray::fromBase64Encoding(root.value(u"key"_s).toString().toLatin1());
    const QJsonValue withdrawn = root.value(u"withdrawn"_s);
    KeyInFile found{root.value(u"name"_s).toString(), key ? *key : QByteArray(), withdrawn.toBool()};
    if (root.value(u"format"_s).toString() != format)
        return tl::unexpected(u"its format is not \"%1\""_s.arg(format));
    if (!isSignerName(found.name) || found.key.size() != size)
        return tl::unexpected(u"its name or its key is invalid"_s);
    if (!withdrawn.isUndefined() && !withdrawn.isBool())
        return tl::unexpected(u"\"withdrawn\" is neither true nor false"_s);
    return found;
}

} // namespace

bool isSignerName(const QString& name)
{
    constexpr qsizetype longest = 64;
    return !name.trimmed().isEmpty() && name.size() <= longest && !hiddenCharacter(name);
}

std::optional<SigningKey> newSigningKey(const QString& name)
{
    if (sodium_init() < 0)
        return std::nullopt;
    QByteArray publicKey(crypto_sign_PUBLICKEYBYTES, '\0');
    SigningKey key{name, QByteArray(crypto_sign_SECRETKEYBYTES, '\0')};
    crypto_sign_keypair(bytesOf(publicKey), bytesOf(key.secret));
    return key;
}

QByteArray secretKeyFile(const SigningKey& key)
{
    return keyFile(secretFormat, key.name, key.secret);
}

QByteArray publicKeyFile(const SigningKey& key)
{
    QByteArray publicKey(crypto_sign_PUBLICKEYBYTES, '\0');
    crypto_sign_ed25519_sk_to_pk(bytesOf(publicKey), bytesOf(key.secret));
    return keyFile(publicFormat, key.name, publicKey);
}

std::optional<SigningKey> secretKeyIn(const QByteArray& file)
{
    const auto found = keyIn(file, secretFormat, crypto_sign_SECRETKEYBYTES);
    return found ? std::optional(SigningKey{found->name, found->key}) : std::nullopt;
}

tl::expected<SignerKey, QString> publicKeyIn(const QByteArray& file)
{
    return keyIn(file, publicFormat, crypto_sign_PUBLICKEYBYTES).map([](const KeyInFile& found) {
        return SignerKey{found.name, found.key, found.isWithdrawn};
    });
}

QList<SignerKey> signerKeys(const QString& folder)
{
    if (folder.isEmpty())
        return {}; // for QDir it would be the working folder
    QList<SignerKey> keys;
    const QFileInfoList files = QDir(folder).entryInfoList({u"*.json"_s}, QDir::Files, QDir::Name);
    for (const QFileInfo& file : files) {
        const auto key = readBytes(file.filePath())
                             .map_error([](const FileError& error) { return error.found; })
                             .and_then(&publicKeyIn);
        if (key)
            keys << *key;
        else
            qCWarning(storeLog).noquote() << printable(
                u"The file %1 is no public key of a signer: %2. It is ignored; correct or remove it."_s.arg(
                    file.filePath(), key.error()));
    }
    return keys;
}

QByteArray signatureOf(const QByteArray& text, const SigningKey& key)
{
    QByteArray signature(crypto_sign_BYTES, '\0');
    crypto_sign_detached(bytesOf(signature), nullptr, bytesOf(text),
                         static_cast<unsigned long long>(text.size()), bytesOf(key.secret));
    return signature;
}

bool isSignedBy(const SignerKey& key, const QByteArray& text, const QByteArray& signature)
{
    return signature.size() == crypto_sign_BYTES &&
           crypto_sign_verify_detached(bytesOf(signature), bytesOf(text),
                                       static_cast<unsigned long long>(text.size()),
                                       bytesOf(key.publicKey)) == 0;
}

SignerTrust trustIn(const QByteArray& text, const QString& signer, const QByteArray& signature,
                    const QList<SignerKey>& keys)
{
    auto trust = SignerTrust::Unknown;
    for (const SignerKey& key : keys) {
        if (key.name != signer)
            continue;
        if (isSignedBy(key, text, signature)) {
            // Whichever file withdraws the key, and under whichever name.
            const bool isWithdrawn = std::ranges::any_of(keys, [&key](const SignerKey& each) {
                return each.isWithdrawn && each.publicKey == key.publicKey;
            });
            return isWithdrawn ? SignerTrust::Withdrawn : SignerTrust::Trusted;
        }
        trust = SignerTrust::Wrong;
    }
    return trust;
}

} // namespace campanel::store
