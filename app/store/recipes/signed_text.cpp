// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/signed_text.h"

#include "app/store/files/json_keys.h"
#include "app/store/files/json_reader.h"

#include <QDateTime>
#include <QJsonDocument>

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr int signedFormatVersion = 1;

// Returns the bytes that are signed: the text comes last, because only it has more than one line.
QByteArray signedBytes(const SignedForm& form, const SignedText& text)
{
    return QStringList{u"%1 %2"_s.arg(form.format, QString::number(signedFormatVersion)), text.signer,
                       text.time, text.mark, text.text}
        .join(u'\n')
        .toUtf8();
}

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
std::pair<SignedText, QByteArray> textIn(const SignedForm& form, const QJsonObject& root,
                                         std::optional<FileError>& failure)
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
    const SignedText text{reader.text(form.textKey), reader.text(u"signed_by"_s),
                          reader.text(u"signed_utc"_s), reader.text(form.markKey)};
    const auto signature = QByteArray::fromBase64Encoding(reader.text(u"signature"_s).toLatin1());
    reader.refuseUnknownKeys();
    return {text, signature ? *signature : QByteArray()};
}

} // namespace

qint64 SignedText::signedMs() const
{
    return QDateTime::fromString(time, Qt::ISODate).toMSecsSinceEpoch();
}

bool isOfForm(const SignedForm& form, const QByteArray& json)
{
    return QJsonDocument::fromJson(json).object().value(u"format"_s).toString() == form.format;
}

QByteArray signText(const SignedForm& form, const QString& text, const QString& mark, qint64 signedMs,
                    const SigningKey& key)
{
    const SignedText made{text, key.name,
                          QDateTime::fromMSecsSinceEpoch(signedMs).toUTC().toString(Qt::ISODate), mark};
    const QByteArray signature = signatureOf(signedBytes(form, made), key).toBase64();
    return QJsonDocument(QJsonObject{{u"format"_s, form.format},
                                     {u"format_version"_s, signedFormatVersion},
                                     {form.textKey, made.text},
                                     {u"signed_by"_s, made.signer},
                                     {u"signed_utc"_s, made.time},
                                     {form.markKey, made.mark},
                                     {u"signature"_s, QString::fromLatin1(signature)}})
        .toJson();
}

tl::expected<SignedText, FileError> verifyText(const SignedForm& form, const QByteArray& json,
                                               const QString& path, const QList<SignerKey>& keys)
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
    const auto [text, signature] = textIn(form, root, failure);
    if (failure)
        return refuse(*failure);
    if (const auto fault = faultOf(trustIn(signedBytes(form, text), text.signer, signature, keys)))
        return refuse({*fault, {}, {}, text.signer, {}, 0});
    return text;
}

} // namespace campanel::store
