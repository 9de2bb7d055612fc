// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/signed_recipe.h"

#include "app/store/files/json_keys.h"
#include "app/store/files/json_reader.h"
#include "app/store/recipes/recipe_json.h"

#include <QDateTime>
#include <QJsonDocument>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString signedFormat = u"campanel-signed-recipe"_s;
constexpr int signedFormatVersion = 1;

// The texts of a signed recipe, as they stand in its file.
struct Envelope {
    QString recipe;
    QString signer;
    QString time;
    QString tableCrc;

    // Returns the text that is signed: the recipe comes last, because only it has more than one line.
    [[nodiscard]] QByteArray text() const
    {
        return QStringList{u"%1 %2"_s.arg(signedFormat, QString::number(signedFormatVersion)), signer, time,
                           tableCrc, recipe}
            .join(u'\n')
            .toUtf8();
    }
};

// Returns the fault of a signature; empty when a key that is trusted has made it.
std::optional<FileError::Kind> faultOf(SignerTrust trust)
{
    switch (trust) {
    case SignerTrust::Trusted:
        break;
    case SignerTrust::Unknown:
        return FileError::Kind::UnknownSigner;
    case SignerTrust::Withdrawn:
        return FileError::Kind::WithdrawnSigner;
    case SignerTrust::Wrong:
        return FileError::Kind::WrongSignature;
    }
    return std::nullopt;
}

// Reads the object; `failure` is set when its form is wrong.
std::pair<Envelope, QByteArray> envelopeIn(const QJsonObject& root, std::optional<FileError>& failure)
{
    ObjectReader reader(root, {}, failure);
    reader.take(u"format"_s);
    profile::FieldInfo versions;
    versions.min = 1;
    versions.max = std::numeric_limits<int>::max();
    const double version = reader.number(u"format_version"_s, true, versions);
    if (version > signedFormatVersion)
        reader.fail(u"format_version"_s, FileError::Kind::NewerVersion, QString::number(version),
                    QString::number(signedFormatVersion));
    const Envelope envelope{reader.text(u"recipe"_s), reader.text(u"signed_by"_s),
                            reader.text(u"signed_utc"_s), reader.text(u"table_crc32"_s)};
    const auto signature = QByteArray::fromBase64Encoding(reader.text(u"signature"_s).toLatin1());
    reader.refuseUnknownKeys();
    return {envelope, signature ? *signature : QByteArray()};
}

} // namespace

bool isSignedRecipe(const QByteArray& json)
{
    return QJsonDocument::fromJson(json).object().value(u"format"_s).toString() == signedFormat;
}

QByteArray signRecipe(const program::Recipe& recipe, qint64 signedMs, std::uint32_t tableCrc,
                      const SigningKey& key)
{
    const Envelope envelope{QString::fromUtf8(toJson(recipe)), key.name,
                            QDateTime::fromMSecsSinceEpoch(signedMs).toUTC().toString(Qt::ISODate),
                            u"%1"_s.arg(tableCrc, 8, 16, QLatin1Char('0')).toUpper()};
    const QByteArray signature = signatureOf(envelope.text(), key).toBase64();
    return QJsonDocument(QJsonObject{{u"format"_s, signedFormat},
                                     {u"format_version"_s, signedFormatVersion},
                                     {u"recipe"_s, envelope.recipe},
                                     {u"signed_by"_s, envelope.signer},
                                     {u"signed_utc"_s, envelope.time},
                                     {u"table_crc32"_s, envelope.tableCrc},
                                     {u"signature"_s, QString::fromLatin1(signature)}})
        .toJson();
}

tl::expected<SignedRecipe, FileError> verifyRecipe(const QByteArray& json, const QString& path,
                                                   const QList<SignerKey>& keys)
{
    const auto refuse = [&path](FileError error) {
        error.path = path;
        return tl::unexpected(error);
    };
    QJsonParseError parseError;
    const QJsonObject root = QJsonDocument::fromJson(json, &parseError).object();
    if (parseError.error != QJsonParseError::NoError)
        return refuse({FileError::Kind::NotJson, {}, {}, parseError.errorString(), {}, parseError.offset});
    if (const auto key = repeatedKey(json))
        return refuse({FileError::Kind::RepeatedKey, {}, *key, {}, {}, 0});
    std::optional<FileError> failure;
    const auto [envelope, signature] = envelopeIn(root, failure);
    if (failure)
        return refuse(*failure);
    if (const auto fault = faultOf(trustIn(envelope.text(), envelope.signer, signature, keys)))
        return refuse({*fault, {}, {}, envelope.signer, {}, 0});
    const auto recipe = fromJson(envelope.recipe.toUtf8(), path);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const QDateTime time = QDateTime::fromString(envelope.time, Qt::ISODate);
    return SignedRecipe{*recipe,
                        {envelope.signer, time.toMSecsSinceEpoch(), envelope.tableCrc.toUInt(nullptr, 16)}};
}

} // namespace campanel::store
