// SPDX-License-Identifier: Apache-2.0
// Signed recipes: what a key has signed is read back, anything else is refused with its reason.
#include "app/store/recipes/recipe_file.h"
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/signed_recipe.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

namespace test_signed_recipe {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using Kind = FileError::Kind;

namespace {

constexpr qint64 signedMs = 1'790'000'000'000;
constexpr std::uint32_t crc = 0x0A1B2C3D;

SigningKey keyOf(const QString& name)
{
    return newSigningKey(name).value();
}

SignerKey publicOf(const SigningKey& key)
{
    return publicKeyIn(publicKeyFile(key)).value();
}

program::Recipe testRecipe()
{
    program::Recipe recipe;
    recipe.name = "Biscuit 250";
    recipe.version = 8;
    return recipe;
}

std::optional<Kind> faultOf(const QByteArray& json, const QList<SignerKey>& keys)
{
    const auto read = verifyRecipe(json, u"offer.json"_s, keys);
    return read ? std::nullopt : std::optional(read.error().kind);
}

QByteArray changed(const QByteArray& json, const QString& key, const QJsonValue& value)
{
    QJsonObject root = QJsonDocument::fromJson(json).object();
    root[key] = value;
    return QJsonDocument(root).toJson();
}

} // namespace

class SignedRecipeTest : public QObject {
    Q_OBJECT

private slots:
    // Test vector 3 of RFC 8032, section 7.1: the same signature as by any other program.
    void signsAsTheStandardSays()
    {
        const QByteArray secret =
            QByteArray::fromHex("c5aa8df43f9f837bedb7442f31dcb7b166d38535076f094b85ce3a2e0b4458f7"
                                "fc51cd8e6218a1a38da47ed00230f0580816ed13ba3303ac5deb911548908025");
        const QByteArray text = QByteArray::fromHex("af82");
        const QByteArray expected =
            QByteArray::fromHex("6291d657deec24024827e69c3abe01a30ce548a284743a445e3680d7db5ac3ac"
                                "18ff9b538d16f290ae67f760984dc6594a7c15e9716ed28dc027beceea1ec40a");
        QCOMPARE(signatureOf(text, {u"Anna"_s, secret}), expected);
        QVERIFY(isSignedBy({u"Anna"_s, secret.right(32)}, text, expected));
    }

    void isReadBack()
    {
        const SigningKey key = keyOf(u"Anna Plant"_s);
        const QByteArray json = signRecipe(testRecipe(), signedMs, crc, key);
        QVERIFY(isSignedRecipe(json));
        QVERIFY(QJsonDocument::fromJson(json).object().value(u"signed_utc"_s).toString().endsWith(u'Z'));
        const auto read = verifyRecipe(json, u"offer.json"_s, {publicOf(key)});
        QVERIFY(read.has_value());
        QCOMPARE(toJson(read->recipe), toJson(testRecipe()));
        QCOMPARE(read->signature.signer, u"Anna Plant"_s);
        QCOMPARE(read->signature.signedMs, signedMs);
        QCOMPARE(read->signature.tableCrc, crc);
    }

    void onlyAValidKeyOpensIt()
    {
        const SigningKey key = keyOf(u"Anna"_s);
        const SigningKey sameName = keyOf(u"Anna"_s);
        const QByteArray json = signRecipe(testRecipe(), signedMs, crc, key);
        SignerKey withdrawn = publicOf(key);
        withdrawn.isWithdrawn = true;
        QCOMPARE(faultOf(json, {}), Kind::UnknownSigner);
        QCOMPARE(faultOf(json, {publicOf(keyOf(u"Bo"_s))}), Kind::UnknownSigner);
        QCOMPARE(faultOf(json, {publicOf(sameName)}), Kind::WrongSignature);
        QCOMPARE(faultOf(json, {withdrawn}), Kind::WithdrawnSigner);
        QCOMPARE(faultOf(json, {withdrawn, publicOf(sameName)}), Kind::WithdrawnSigner);
        QCOMPARE(faultOf(json, {publicOf(sameName), publicOf(key)}), std::nullopt);
        // Withdrawn in one file is withdrawn in all of them, and under each name.
        QCOMPARE(faultOf(json, {publicOf(key), withdrawn}), Kind::WithdrawnSigner);
        QCOMPARE(faultOf(json, {withdrawn, publicOf(key)}), Kind::WithdrawnSigner);
        withdrawn.name = u"Anna, until May"_s;
        QCOMPARE(faultOf(json, {publicOf(key), withdrawn}), Kind::WithdrawnSigner);
    }

    void everyChangeIsFound_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("person") << u"signed_by"_s << u"Bo"_s;
        QTest::newRow("time") << u"signed_utc"_s << u"2026-09-21T14:13:21Z"_s;
        QTest::newRow("table") << u"table_crc32"_s << u"0A1B2C3E"_s;
        QTest::newRow("signature") << u"signature"_s << u"AAAA"_s;
        QTest::newRow("no base64") << u"signature"_s << u"%%"_s;
    }
    void everyChangeIsFound()
    {
        QFETCH(QString, key);
        QFETCH(QString, value);
        const SigningKey anna = keyOf(u"Anna"_s);
        const QList<SignerKey> keys{publicOf(anna), {u"Bo"_s, publicOf(anna).publicKey}};
        QCOMPARE(faultOf(changed(signRecipe(testRecipe(), signedMs, crc, anna), key, value), keys),
                 Kind::WrongSignature);
    }

    // No bit of a signed file can change without an error, or with another recipe.
    void noBitChangesTheRecipe()
    {
        const SigningKey key = keyOf(u"Anna"_s);
        const QByteArray json = signRecipe(testRecipe(), signedMs, crc, key);
        constexpr quint32 seed = 20261124;
        QRandomGenerator random(seed);
        constexpr int tries = 1000;
        for (int i = 0; i < tries; ++i) {
            QByteArray bent = json;
            const qsizetype place = random.bounded(static_cast<int>(json.size()));
            bent[place] = static_cast<char>(bent[place] ^ (1 << random.bounded(8)));
            const auto read = verifyRecipe(bent, u"offer.json"_s, {publicOf(key)});
            QVERIFY2(!read || toJson(read->recipe) == toJson(testRecipe()),
                     qPrintable(u"seed %1, bit at byte %2"_s.arg(seed).arg(place)));
        }
    }

    void damagedFiles()
    {
        const SigningKey key = keyOf(u"Anna"_s);
        const QList<SignerKey> keys{publicOf(key)};
        const QByteArray json = signRecipe(testRecipe(), signedMs, crc, key);
        QCOMPARE(faultOf(changed(json, u"more"_s, 1), keys), Kind::UnknownKey);
        QCOMPARE(faultOf(changed(json, u"recipe"_s, 1), keys), Kind::WrongType);
        QCOMPARE(faultOf(changed(json, u"format_version"_s, 2), keys), Kind::NewerVersion);
        QCOMPARE(faultOf("{\"format\":\"campanel-signed-recipe\"}", keys), Kind::MissingKey);
        QVERIFY(!isSignedRecipe(json.left(json.size() / 2)));
        QVERIFY(!isSignedRecipe(toJson(testRecipe())));
    }

    void filesOfKeys()
    {
        const SigningKey key = keyOf(u"Anna"_s);
        QCOMPARE(secretKeyIn(secretKeyFile(key))->secret, key.secret);
        QVERIFY(!secretKeyIn(publicKeyFile(key)));
        QVERIFY(!publicKeyIn(secretKeyFile(key)));
        QVERIFY(!publicKeyIn("{}"));
        QVERIFY(!publicKeyIn(changed(publicKeyFile(key), u"withdrawn"_s, u"maybe"_s)));
        QVERIFY(publicKeyIn(changed(publicKeyFile(key), u"withdrawn"_s, true))->isWithdrawn);
        // The key may be a misspelled "withdrawn", or one that another value hides.
        for (const QString& misspelled : {u"widthdrawn"_s, u"Withdrawn"_s, u"withdrawn "_s, u"comment"_s})
            QCOMPARE(publicKeyIn(changed(publicKeyFile(key), misspelled, true)).error(),
                     u"\"%1\" is unknown"_s.arg(misspelled));
        for (const char* twice : {"\"withdrawn\": true, \"withdrawn\": false, ",
                                  "\"withdrawn\": true, \"with\\u0064rawn\": false, "}) {
            QByteArray file = publicKeyFile(key);
            QCOMPARE(publicKeyIn(file.insert(file.indexOf('"'), twice)).error(),
                     u"it has \"withdrawn\" twice"_s);
        }
        QVERIFY(!publicKeyIn("[" + publicKeyFile(key) + "]"));
        QVERIFY(!isSignerName(u" "_s));
        QVERIFY(!isSignerName(u"Anna\nPlant"_s));
        QVERIFY(!isSignerName(QString(65, u'a')));
    }

    void withoutAFolderNobodyIsTrusted()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(u"anna.json"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(publicKeyFile(keyOf(u"Anna"_s))) > 0);
        file.close();
        QCOMPARE(signerKeys(folder.path()).size(), 1);
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder.path()));
        const qsizetype trusted = signerKeys({}).size();
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(trusted, 0);
    }

    void offersSayWhoSigned()
    {
        const QTemporaryDir folder;
        const auto write = [&folder](const QString& name, const QByteArray& bytes) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        };
        QVERIFY(QDir(folder.path()).mkdir(u"keys"_s));
        QVERIFY(QDir(folder.path()).mkdir(u"stick"_s));
        const SigningKey anna = keyOf(u"Anna"_s);
        write(u"keys/anna.json"_s, publicKeyFile(anna));
        write(u"keys/notes.json"_s, "{}");
        write(u"stick/plain.json"_s, toJson(testRecipe()));
        write(u"stick/signed.json"_s, signRecipe(testRecipe(), signedMs, crc, anna));
        write(u"stick/other.json"_s, signRecipe(testRecipe(), signedMs, crc, keyOf(u"Bo"_s)));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(u"notes.json.* is no public key"_s));
        QList<RecipeOffer> offers =
            offeredRecipes({{folder.filePath(u"stick"_s), u"Stick"_s}}, folder.filePath(u"keys"_s));
        std::ranges::sort(offers, {}, &RecipeOffer::path);
        QCOMPARE(offers.size(), 3);
        QCOMPARE(offers[0].recipe.error().kind, Kind::UnknownSigner);
        QVERIFY(offers[1].recipe && !offers[1].signature);
        QVERIFY(offers[2].recipe && offers[2].signature->signer == u"Anna"_s);
    }
};

CAMPANEL_TEST(SignedRecipeTest)

} // namespace test_signed_recipe

#include "test_signed_recipe.moc"
