// SPDX-License-Identifier: Apache-2.0
// The check of the files that a machine builder puts on the card of an image.
#include "app/shell/card.h"
#include "tests/support/test_program.h"

#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/recipe_keys.h"
#include "app/store/recipes/signed_recipe.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_card {

using namespace Qt::StringLiterals;
using campanel::shell::CardFile;
using campanel::shell::checkCard;

class TestCard : public QObject {
    Q_OBJECT

private slots:
    void files_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("error"); // a part of it; empty: the file is good
        const auto key = *campanel::store::newSigningKey(u"Anna"_s);
        const campanel::program::Recipe recipe;
        const QByteArray named = "[connection]\nport = \"/dev/campanel-serial\"\n";
        const QString plain = u"letters of English"_s;
        const QString nothing = u"Nothing takes this file"_s;
        const auto row = [](const char* title, const QString& name, const QByteArray& content,
                            const QString& error = {}) { QTest::newRow(title) << name << content << error; };
        row("settings", u"campanel.toml"_s, named);
        row("simulated", u"campanel.toml"_s, "[connection]\nsimulated = true\n");
        row("no controller", u"campanel.toml"_s, "[display]\ntheme = \"dark\"\n", u"names no controller"_s);
        row("no TOML", u"campanel.toml"_s, named + "theme = = dark\n", u"campanel.toml:3"_s);
        row("unknown key", u"campanel.toml"_s, named + "prot = 3\n", u"there is no key"_s);
        row("empty settings", u"campanel.toml"_s, {}, u"names no controller"_s);
        row("large settings", u"campanel.toml"_s, QByteArray(2 << 20, '#'), u"1 MB"_s);
        row("key", u"recipe-keys/anna.json"_s, publicKeyFile(key));
        row("key of packages", u"package-keys/anna.json"_s, publicKeyFile(key));
        row("secret key", u"recipe-keys/anna.json"_s, secretKeyFile(key), u"no public key"_s);
        row("key elsewhere", u"keys/anna.json"_s, publicKeyFile(key), nothing);
        row("recipe", u"recipes/Biscuit 250.json"_s, campanel::store::toJson(recipe));
        row("signed recipe", u"recipes/signed.json"_s, signRecipe(recipe, 1'790'000'000'000, 1, key));
        row("half a recipe", u"recipes/half.json"_s, campanel::store::toJson(recipe).chopped(20),
            u"half.json"_s);
        row("recipe in a folder", u"recipes/old/biscuit.json"_s, campanel::store::toJson(recipe), nothing);
        row("text", u"recipes/readme.txt"_s, "hello", nothing);
        row("name of the computer", u"hostname"_s, "packer-7\r\n");
        row("name with a space", u"hostname"_s, "packer 7\n", u"one line"_s);
        row("two names", u"hostname"_s, "packer\nseven\n", u"one line"_s);
        row("no name", u"hostname"_s, "\n", u"one line"_s);
        row("file that is an option", u"recipes/-rf.json"_s, campanel::store::toJson(recipe), plain);
        row("file with a quote", u"recipes/a'b.json"_s, campanel::store::toJson(recipe), plain);
        row("file with a line feed", u"recipes/a\nb.json"_s, campanel::store::toJson(recipe), plain);
        row("file with umlauts", u"recipes/Stück.json"_s, campanel::store::toJson(recipe), plain);
    }

    void files()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, error);
        const QTemporaryDir folder;
        const QString path = folder.filePath(name);
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        const QList<CardFile> checked = checkCard(folder.path());
        QCOMPARE(checked.size(), 1);
        QCOMPARE(checked.first().name, name);
        QCOMPARE(checked.first().error.isEmpty(), error.isEmpty());
        QVERIFY2(checked.first().error.contains(error), qPrintable(checked.first().error));
    }

    void filesOfOtherComputersAreNoErrors()
    {
        const QTemporaryDir folder;
        for (const QString& name : {u".DS_Store"_s, u"Thumbs.db"_s, u"desktop.ini"_s, u"._campanel.toml"_s}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        QVERIFY(checkCard(folder.path()).isEmpty());
        QVERIFY(checkCard(folder.filePath(u"none"_s)).isEmpty());
    }
};

CAMPANEL_TEST(TestCard)

} // namespace test_card

#include "test_card.moc"
