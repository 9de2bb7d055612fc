// SPDX-License-Identifier: Apache-2.0
#include "app/store/update/signed_package.h"

#include "app/store/files/files.h"
#include "app/store/files/json_keys.h"
#include "app/store/files/json_reader.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>
#include <QJsonDocument>

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Kind = PackageFault::Kind;

const QString signatureFormat = u"campanel-package-signature"_s;
constexpr int signatureVersion = 1;

// The text that is signed. Its first line is that of no signed recipe.
QByteArray signedText(const PackageSignature& signature)
{
    return QStringList{u"%1 %2"_s.arg(signatureFormat, QString::number(signatureVersion)),
                       signature.signer,
                       QDateTime::fromMSecsSinceEpoch(signature.signedMs).toUTC().toString(Qt::ISODate),
                       signature.package.name,
                       signature.package.version,
                       signature.package.architecture,
                       QString::number(signature.bytes),
                       QString::fromLatin1(signature.sha256.toHex())}
        .join(u'\n')
        .toUtf8();
}

tl::expected<QByteArray, PackageFault> hashOf(const QString& path)
{
    const auto file = openRegular(path);
    if (!file)
        return tl::unexpected(PackageFault{Kind::NotReadable, path, file.error().found});
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!hash.addData(file->get()))
        return tl::unexpected(PackageFault{Kind::NotReadable, path, (*file)->errorString()});
    return hash.result();
}

struct Envelope {
    PackageSignature content;
    QByteArray signature;
};

tl::expected<Envelope, Kind> envelopeIn(const QByteArray& json)
{
    const QJsonObject root = QJsonDocument::fromJson(json).object();
    std::optional<FileError> failure;
    ObjectReader reader(root, {}, failure);
    if (reader.text(u"format"_s) != signatureFormat || repeatedKey(json))
        return tl::unexpected(Kind::WrongSignature);
    profile::FieldInfo limits;
    limits.min = 1;
    limits.max = std::numeric_limits<int>::max();
    if (reader.number(u"format_version"_s, true, limits) > signatureVersion)
        return tl::unexpected(Kind::NewerSignature);
    Envelope envelope;
    PackageSignature& content = envelope.content;
    content.signer = reader.text(u"signed_by"_s);
    content.signedMs = QDateTime::fromString(reader.text(u"signed_utc"_s), Qt::ISODate).toMSecsSinceEpoch();
    content.package = {reader.text(u"package"_s), reader.text(u"version"_s), reader.text(u"architecture"_s)};
    content.bytes = static_cast<qint64>(reader.number(u"bytes"_s, true, limits));
    content.sha256 = QByteArray::fromHex(reader.text(u"sha256"_s).toLatin1());
    const auto signature = QByteArray::fromBase64Encoding(reader.text(u"signature"_s).toLatin1());
    reader.refuseUnknownKeys();
    if (failure || !signature)
        return tl::unexpected(Kind::WrongSignature);
    envelope.signature = *signature;
    return envelope;
}

} // namespace

QString signaturePath(const QString& package)
{
    return package + u".sig"_s;
}

tl::expected<QByteArray, PackageFault> signPackage(const QString& path, qint64 signedMs,
                                                   const SigningKey& key)
{
    const auto package = packageIn(path);
    if (!package)
        return tl::unexpected(PackageFault{Kind::NotAPackage, path, {}});
    const auto hash = hashOf(path);
    if (!hash)
        return tl::unexpected(hash.error());
    const PackageSignature content{*package, QFileInfo(path).size(), *hash, key.name, signedMs};
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(signedMs).toUTC();
    return QJsonDocument(QJsonObject{{u"format"_s, signatureFormat},
                                     {u"format_version"_s, signatureVersion},
                                     {u"signed_by"_s, content.signer},
                                     {u"signed_utc"_s, time.toString(Qt::ISODate)},
                                     {u"package"_s, package->name},
                                     {u"version"_s, package->version},
                                     {u"architecture"_s, package->architecture},
                                     {u"bytes"_s, content.bytes},
                                     {u"sha256"_s, QString::fromLatin1(content.sha256.toHex())},
                                     {u"signature"_s,
                                      QString::fromLatin1(signatureOf(signedText(content), key).toBase64())}})
        .toJson();
}

tl::expected<PackageSignature, PackageFault> verifyPackage(const QString& path, const QList<SignerKey>& keys)
{
    const auto refuse = [&path](Kind kind, const QString& detail = {}) {
        return tl::unexpected(PackageFault{kind, path, detail});
    };
    if (!QFileInfo::exists(signaturePath(path)))
        return refuse(Kind::NotSigned);
    const auto json = readBytes(signaturePath(path));
    if (!json)
        return refuse(Kind::NotReadable, json.error().found);
    const auto envelope = envelopeIn(*json);
    if (!envelope)
        return refuse(envelope.error());
    const PackageSignature& content = envelope->content;
    switch (trustIn(signedText(content), content.signer, envelope->signature, keys)) {
    case SignerTrust::Trusted:
        break;
    case SignerTrust::Unknown:
        return refuse(Kind::UnknownSigner, content.signer);
    case SignerTrust::Withdrawn:
        return refuse(Kind::WithdrawnSigner, content.signer);
    case SignerTrust::Wrong:
        return refuse(Kind::WrongSignature);
    }
    if (QFileInfo(path).size() != content.bytes)
        return refuse(Kind::Damaged);
    const auto hash = hashOf(path);
    if (!hash)
        return tl::unexpected(hash.error());
    if (*hash != content.sha256)
        return refuse(Kind::Damaged);
    return content;
}

} // namespace campanel::store
