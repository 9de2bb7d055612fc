// SPDX-License-Identifier: Apache-2.0
// packaging/card's make-ready in a folder: what is good is taken, what is not is reported, a power cut at any
// step leaves whole files, and the next boot finishes.
#include "script_root.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include "app/program/recipe.h"
#include "app/store/recipes/recipe_json.h"

namespace test_card_script {

using namespace Qt::StringLiterals;
using campanel::test::ScriptRoot;

namespace {

const QByteArray settings = "[connection]\nport = \"/dev/campanel-serial\"\n";
const QString card = u"run/campanel-card/campanel/"_s;
const QString mark = u"var/lib/campanel-card/taken"_s;
const QString left = u"var/lib/campanel/made-ready/"_s;

struct Card : ScriptRoot {
    Card()
    {
        QVERIFY(QFile::link(campanel::test::programPath("campanel"), path(u"bin/campanel"_s)));
        write(u"etc/hosts"_s, "127.0.0.1 localhost\n127.0.1.1 campanel\n");
        write(u"etc/hostname"_s, "campanel\n");
        write(u"etc/campanel/campanel.toml"_s, "[display]\ntheme = \"dark\"\n");
        write(u"usr/x"_s, {});
    }
    void put(const QByteArray& toml)
    {
        write(card + u"campanel.toml"_s, toml);
        write(card + u"hostname"_s, "packer-7\r\n");
        write(card + u"recipes/Biscuit 250.json"_s, campanel::store::toJson({}));
    }
    void boot()
    {
        QVERIFY(run(campanel::test::sourcePath("packaging/card/files/usr/libexec/campanel-card/make-ready"),
                    u"CAMPANEL_CARD_ROOT"_s));
    }
};

} // namespace

class TestCardScript : public QObject {
    Q_OBJECT

private slots:
    void goodFilesAreTakenOnce()
    {
        Card root;
        root.put(settings);
        root.boot();
        const QByteArray log = root.read(u"log"_s);
        QVERIFY2(root.read(u"etc/campanel/campanel.toml"_s) == settings, log);
        QCOMPARE(root.read(u"etc/hostname"_s), "packer-7\n"_ba);
        QCOMPARE(root.read(u"etc/hosts"_s), "127.0.0.1 localhost\n127.0.1.1 packer-7\n"_ba);
        QCOMPARE(root.read(left + u"recipes/Biscuit 250.json"_s), campanel::store::toJson({}));
        QCOMPARE(root.read(left + u"report"_s),
                 "campanel.toml\tok\nhostname\tok\nrecipes/Biscuit 250.json\tok\n"_ba);
        QVERIFY(root.exists(mark));
        QCOMPARE(root.writableFiles(), QByteArrayList());
    }

    void aBadFileIsReportedAndReadAgain()
    {
        Card root;
        root.put(settings + "x = \n");
        root.boot();
        QCOMPARE(root.read(u"etc/campanel/campanel.toml"_s), "[display]\ntheme = \"dark\"\n"_ba);
        QCOMPARE(root.read(u"etc/hostname"_s), "packer-7\n"_ba);
        QVERIFY(root.read(left + u"report"_s).startsWith("campanel.toml\tcampanel.toml:3:"));
        QVERIFY(!root.exists(mark));
        root.put(settings);
        root.boot();
        QCOMPARE(root.read(u"etc/campanel/campanel.toml"_s), settings);
        QVERIFY(root.exists(mark));
    }

    void withoutAFolderNothingChanges()
    {
        Card root;
        root.boot();
        QVERIFY(!root.exists(mark) && !root.exists(left));
        root.write(card + u".DS_Store"_s, {});
        root.boot();
        QVERIFY(!root.exists(mark) && !root.exists(left));
        QCOMPARE(root.read(u"log"_s), QByteArray());
    }

    void aPowerCutAtAnyStepLeavesWholeFiles()
    {
        for (int step = 1;; ++step) {
            Card root;
            root.put(settings);
            root.write(u"kill-at"_s, QByteArray::number(step));
            root.boot();
            const QByteArray toml = root.read(u"etc/campanel/campanel.toml"_s);
            QVERIFY2(toml == settings || toml.startsWith("[display]"), toml);
            QVERIFY(root.read(u"etc/hosts"_s).startsWith("127.0.0.1 localhost\n127.0.1.1 "));
            if (root.exists(left))
                QVERIFY(root.exists(left + u"recipes/Biscuit 250.json"_s) && root.exists(left + u"report"_s));
            if (root.exists(mark)) {
                QVERIFY(step > 10);
                break;
            }
            QVERIFY(QFile::remove(root.path(u"kill-at"_s)));
            root.boot();
            QVERIFY2(root.exists(mark), root.read(u"log"_s));
            QCOMPARE(root.read(u"etc/campanel/campanel.toml"_s), settings);
            QCOMPARE(root.read(left + u"recipes/Biscuit 250.json"_s), campanel::store::toJson({}));
        }
    }
};

CAMPANEL_TEST(TestCardScript)

} // namespace test_card_script

#include "test_card_script.moc"
