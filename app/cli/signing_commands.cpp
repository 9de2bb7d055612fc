// SPDX-License-Identifier: Apache-2.0
// campanelctl recipe new-key, sign and verify: recipes that a panel accepts from outside.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "app/cli/signed_file.h"
#include "app/program/program_image.h"
#include "app/store/files/files.h"
#include "app/store/files/private_files.h"
#include "app/store/recipes/recipe_file.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

// Returns the error of a call without its file or option.
std::optional<Failure> missing(const Invocation& call, const QString& usage, const QString& option,
                               qsizetype words)
{
    if (call.arguments().size() == words && call.isSet(option))
        return std::nullopt;
    return Failure{ExitCode::Usage, u"Usage: campanelctl recipe %1."_s.arg(usage)};
}

} // namespace

Outcome createKey(const Invocation& call)
{
    if (const auto failure = missing(call, u"new-key --name NAME --key SECRET"_s, u"key"_s, 1))
        return tl::unexpected(*failure);
    const QString name = call.value(u"name"_s);
    if (!store::isSignerName(name))
        return fail(ExitCode::Usage, u"--name takes 1 to 64 characters: the name of the signer."_s);
    const QString path = call.value(u"key"_s);
    if (QFileInfo::exists(path))
        return fail(ExitCode::File,
                    u"%1 exists. Name a new file; a key that is lost cannot be made again."_s.arg(path));
    const auto key = store::newSigningKey(name);
    if (!key)
        return fail(ExitCode::File, u"This computer has no random numbers for a key."_s);
    if (!store::makePrivateFile(path))
        return fail(ExitCode::File, u"%1 cannot be written: %2."_s.arg(path, qt_error_string()));
    Outcome done = call.deliver(store::publicKeyFile(*key));
    if (const auto written = store::replaceBytes(path, store::secretKeyFile(*key)); done && !written)
        done = fail(ExitCode::File, u"%1 cannot be written: %2."_s.arg(path, written.error().found));
    if (!done)
        QFile::remove(path); // a secret key without its public one is of no use
    return done;
}

Outcome signFile(const Invocation& call)
{
    if (const auto failure = missing(call, u"sign RECIPE.json --key SECRET"_s, u"key"_s, 2))
        return tl::unexpected(*failure);
    const auto key = secretKeyOf(call);
    if (!key)
        return tl::unexpected(key.error());
    const auto recipe = store::readRecipe(call.arguments().last());
    if (!recipe)
        return fail(recipe.error());
    const auto image = program::buildProgram(*recipe);
    if (!image)
        return fail(image.error());
    return call.deliver(store::signRecipe(*recipe, QDateTime::currentMSecsSinceEpoch(), image->crc, *key));
}

Outcome verifyFile(const Invocation& call)
{
    if (const auto failure = missing(call, u"verify SIGNED.json --keys FOLDER"_s, u"keys"_s, 2))
        return tl::unexpected(*failure);
    const auto keys = publicKeysOf(call);
    if (!keys)
        return tl::unexpected(keys.error());
    const auto valid = readSignedRecipe(call.arguments().last(), *keys);
    if (!valid)
        return tl::unexpected(valid.error());
    const auto image = program::buildProgram(valid->recipe);
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(valid->signature.signedMs).toUTC();
    return call.deliver(QJsonDocument(QJsonObject{{u"name"_s, QString::fromStdString(valid->recipe.name)},
                                                  {u"version"_s, valid->recipe.version},
                                                  {u"signed_by"_s, valid->signature.signer},
                                                  {u"signed_utc"_s, time.toString(Qt::ISODate)},
                                                  {u"table_crc32"_s, crcText(valid->signature.tableCrc)},
                                                  {u"table_is_the_signed_one"_s,
                                                   image && image->crc == valid->signature.tableCrc}})
                            .toJson());
}

} // namespace campanel::cli
