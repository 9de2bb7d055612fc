// SPDX-License-Identifier: Apache-2.0
// campanelctl package: signs packages of CamPanel, and checks them as an update from a stick does.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/signed_file.h"
#include "app/panel/words/package_sentences.h"
#include "app/store/update/signed_package.h"

#include <QDateTime>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

tl::unexpected<Failure> refuse(const store::PackageFault& fault)
{
    using Kind = store::PackageFault::Kind;
    const bool isFile = fault.kind == Kind::NotReadable || fault.kind == Kind::NotAPackage;
    return fail(isFile ? ExitCode::File : ExitCode::Refused, panel::PackageSentences::fault(fault));
}

Outcome signPackage(const Invocation& call)
{
    const auto key = secretKeyOf(call);
    if (!key)
        return tl::unexpected(key.error());
    const auto signature =
        store::signPackage(call.arguments().last(), QDateTime::currentMSecsSinceEpoch(), *key);
    if (!signature)
        return refuse(signature.error());
    return call.deliver(*signature);
}

Outcome verifyPackage(const Invocation& call)
{
    const auto keys = publicKeysOf(call);
    if (!keys)
        return tl::unexpected(keys.error());
    const auto valid = store::verifyPackage(call.arguments().last(), *keys);
    if (!valid)
        return refuse(valid.error());
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(valid->signedMs).toUTC();
    return call.deliver(QJsonDocument(QJsonObject{{u"package"_s, valid->package.name},
                                                  {u"version"_s, valid->package.version},
                                                  {u"architecture"_s, valid->package.architecture},
                                                  {u"bytes"_s, valid->bytes},
                                                  {u"signed_by"_s, valid->signer},
                                                  {u"signed_utc"_s, time.toString(Qt::ISODate)}})
                            .toJson());
}

} // namespace

Outcome runPackage(const Invocation& call)
{
    const QString word = call.arguments().value(0);
    const qsizetype words = call.arguments().size();
    if (word == u"sign" && words == 2 && call.isSet(u"key"_s))
        return signPackage(call);
    if (word == u"verify" && words == 2 && call.isSet(u"keys"_s))
        return verifyPackage(call);
    if (word == u"schema" && words == 1)
        return call.deliver(store::dataSchema().toUtf8() + '\n');
    return fail(ExitCode::Usage, u"Usage: campanelctl package sign FILE.deb --key SECRET, "
                                 "verify FILE.deb --keys FOLDER, or schema."_s);
}

} // namespace campanel::cli
