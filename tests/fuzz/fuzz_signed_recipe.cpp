// SPDX-License-Identifier: Apache-2.0
// Signed recipes: any bytes; and an envelope that our key has signed, with any text as recipe, time and
// checksum. Nothing passes without the signature of a trusted key.
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/signed_recipe.h"
#include "tests/fuzz/fuzz_target.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace campanel::fuzz {
namespace {

using namespace campanel::store;
using namespace Qt::StringLiterals;

// Returns the key of this run.
const SigningKey& signer()
{
    static const SigningKey key = newSigningKey(u"Anna"_s).value();
    return key;
}

const QList<SignerKey>& trusted()
{
    static const QList<SignerKey> keys{publicKeyIn(publicKeyFile(signer())).value()};
    return keys;
}

// Returns a signed envelope; each text ends at a zero byte of the input.
QByteArray envelope(std::span<const std::uint8_t> bytes)
{
    const QByteArray all(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    const QList<QByteArray> texts = all.split('\0');
    const auto text = [&texts](int index) {
        return index < texts.size() ? QString::fromUtf8(texts[index]) : QString();
    };
    const QString time = text(0);
    const QString crc = text(1);
    const QString recipe = text(2);
    const QByteArray content =
        QStringList{u"campanel-signed-recipe 1"_s, signer().name, time, crc, recipe}.join(u'\n').toUtf8();
    return QJsonDocument(
               QJsonObject{{u"format"_s, u"campanel-signed-recipe"_s},
                           {u"format_version"_s, 1},
                           {u"recipe"_s, recipe},
                           {u"signed_by"_s, signer().name},
                           {u"signed_utc"_s, time},
                           {u"table_crc32"_s, crc},
                           {u"signature"_s, QString::fromLatin1(signatureOf(content, signer()).toBase64())}})
        .toJson();
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    InputReader input(bytes);
    const bool isSigned = (input.byte() & 1u) != 0;
    const auto rest = input.rest();
    const QByteArray raw(reinterpret_cast<const char*>(rest.data()), static_cast<qsizetype>(rest.size()));
    const QByteArray json = isSigned ? envelope(rest) : raw;
    (void)isSignedRecipe(json);
    const auto verified = verifyRecipe(json, u"signed.json"_s, trusted());
    require(!verified || isSigned, "nothing passes without a signature of the key of this run");
    if (!verified)
        require(!FileErrorText::describe(verified.error()).isEmpty(), "a refusal has a sentence");
    require(!verifyRecipe(json, u"signed.json"_s, {}), "nothing passes where no key is trusted");
    (void)publicKeyIn(raw);
    (void)secretKeyIn(raw);
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds;
    const auto add = [&seeds](char manner, const QByteArray& text) {
        const QByteArray whole = manner + text;
        seeds.push_back(bytesOf({whole.constData(), static_cast<std::size_t>(whole.size())}));
    };
    const program::Recipe recipe;
    const QByteArray zero(1, '\0');
    add(1, "2026-08-01T12:00:00Z" + zero + "89ABCDEF" + zero + toJson(recipe));
    add(0, R"({"format":"campanel-signed-recipe","format_version":1,"recipe":"{}","signed_by":"Anna",)"
           R"("signed_utc":"2026-08-01T12:00:00Z","table_crc32":"89ABCDEF","signature":"AAAA"})");
    add(0, R"({"format":"campanel-recipe-key","name":"Anna"})");
    return seeds;
}

} // namespace campanel::fuzz
