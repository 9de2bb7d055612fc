// SPDX-License-Identifier: Apache-2.0
// The panel takes what the machine builder put on the card: recipes and machine data of a new panel, and the
// report of the boot.
#include "app/panel/library/builder_files.h"
#include "app/panel/library/recipes.h"
#include "tests/app/panel/panel_rig.h"

#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/signed_recipe.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>

namespace campanel::panel::test_builder_files {

using namespace Qt::StringLiterals;

namespace {

constexpr int pulsesOfBuilder = 20'000; // the default is 10 000

program::Recipe recipe(const char* name, double bagLengthMm, int pulses = pulsesOfBuilder)
{
    program::Recipe made;
    made.name = name;
    made.cutter().bagLengthMm = bagLengthMm;
    made.machine.pulsesPerMotorRev = pulses;
    return made;
}

// A panel on the files of a folder, and the folder that the boot left.
struct Start {
    test::PanelRig rig;
    Editor editor;
    DatabaseService records;
    Recipes recipes;
    BuilderFiles files;
    QSignalSpy noted{&files, &BuilderFiles::noted};
    QString card;

    explicit Start(const QTemporaryDir& folder)
        : editor(rig.machine, folder.path(), nullptr)
        , records(folder.path(), nullptr)
        , recipes(rig.machine, editor, records, folder.path(), nullptr)
        , files(recipes, records, nullptr)
        , card(folder.filePath(u"made-ready"_s))
    {
    }
    void put(const QString& name, const QByteArray& bytes) const
    {
        QVERIFY(QDir().mkpath(QFileInfo(QDir(card).filePath(name)).path()));
        QFile file(QDir(card).filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    void open(const QStringList& complaints = {})
    {
        const bool isThere = QFileInfo::exists(card);
        files.open(card, QDir(card).filePath(u"../keys"_s), complaints);
        records.open();
        QTRY_VERIFY(recipes.ready());
        QTRY_VERIFY(!QFileInfo::exists(card));
        if (isThere)
            settle();
    }
    void settle()
    {
        for (int round = 0; round < 6; ++round) {
            bool isDone = false;
            records.store().run(
                &recipes, [](store::Database&) { return true; }, [&isDone](bool) { isDone = true; });
            QTRY_VERIFY(isDone);
        }
    }
    QStringList names()
    {
        QStringList found;
        for (const RecipeRow& row : recipes.list()->rows())
            found << u"%1 v%2"_s.arg(row.name).arg(row.version);
        found.sort();
        return found;
    }
    QStringList notes() const
    {
        QStringList found;
        for (const auto& each : noted) {
            const auto entry = each.first().value<store::AuditEntry>();
            found << u"%1 %2"_s.arg(entry.object, entry.outcome);
        }
        return found;
    }
};

} // namespace

class TestBuilderFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::C); }

    void aNewPanelHasRecipesAndMachineDataOfTheBuilder()
    {
        const QTemporaryDir folder;
        {
            Start start(folder);
            start.put(u"report"_s, "campanel.toml\tok\nrecipes/b.json\tok\nrecipes/a.json\tok\n");
            start.put(u"recipes/b.json"_s, store::toJson(recipe("Soap", 180, 15'000)));
            start.put(u"recipes/a.json"_s, store::toJson(recipe("Rusk", 300)));
            start.open();
            QCOMPARE(start.names(), QStringList({u"Rusk v1"_s, u"Soap v1"_s}));
            QCOMPARE(start.editor.recipeName(), u"Rusk"_s); // the first by its file's name
            QCOMPARE(start.editor.recipe().machine.pulsesPerMotorRev, pulsesOfBuilder);
            QCOMPARE(start.recipes.named(u"Soap"_s)->recipe.machine.pulsesPerMotorRev, pulsesOfBuilder);
            QCOMPARE(start.files.notice(), u"Taken from the card: campanel.toml, recipes: 2."_s);
            QCOMPARE(start.notes(), QStringList{u"campanel.toml done"_s});
            start.files.dismissNotice();
            QVERIFY(start.files.notice().isEmpty());
        }
        Start start(folder); // once
        start.open();
        QCOMPARE(start.names(), QStringList({u"Rusk v1"_s, u"Soap v1"_s}));
        QCOMPARE(start.editor.recipeName(), u"Rusk"_s);
        QCOMPARE(start.editor.notice(), QString());
        QVERIFY(start.files.notice().isEmpty());
        QCOMPARE(start.notes(), QStringList());
    }

    void aPanelInUseKeepsItsMachineDataAndItsOpenRecipe()
    {
        const QTemporaryDir folder;
        {
            Start start(folder);
            start.open();
            start.recipes.setWantedName(u"Mine"_s);
            start.recipes.saveAs();
            start.settle();
        }
        Start start(folder);
        start.put(u"recipes/a.json"_s, store::toJson(recipe("Rusk", 300)));
        start.open();
        QCOMPARE(start.names(), QStringList({u"Mine v1"_s, u"Rusk v1"_s}));
        QCOMPARE(start.editor.recipeName(), u"Mine"_s);
        QCOMPARE(start.recipes.named(u"Rusk"_s)->recipe.machine.pulsesPerMotorRev,
                 program::Recipe{}.machine.pulsesPerMotorRev);
        QCOMPARE(start.files.notice(), u"Taken from the card: recipes: 1."_s);
    }

    // A power cut before the folder was removed.
    void takenTwiceChangesNothing()
    {
        const QTemporaryDir folder;
        for (int i = 0; i < 2; ++i) {
            Start start(folder);
            start.put(u"recipes/a.json"_s, store::toJson(recipe("Rusk", 300)));
            start.open();
            QCOMPARE(start.names(), QStringList{u"Rusk v1"_s});
            QCOMPARE(start.editor.recipeName(), u"Rusk"_s);
        }
    }

    void whatIsRefusedIsSaidAndTold()
    {
        const QTemporaryDir folder;
        const auto stranger = *store::newSigningKey(u"Stranger"_s);
        Start start(folder);
        start.put(u"report"_s, "campanel.toml\tLine 3 is wrong.\nrecipes/half.json\tok\nhostname\tok\n");
        start.put(u"recipes/half.json"_s, store::toJson(recipe("Rusk", 300)).chopped(30));
        start.put(u"recipes/other.json"_s,
                  store::signRecipe(recipe("Soap", 180), 1'790'000'000'000, 1, stranger));
        start.open({u"/etc/campanel/campanel.toml:1: there is no key x; it is ignored."_s});
        QCOMPARE(start.names(), QStringList());
        const QString notice = start.files.notice();
        QVERIFY2(notice.startsWith(u"/etc/campanel/campanel.toml:1: there is no key x; it is ignored. Not "
                                   "taken from the card: campanel.toml. Line 3 is wrong. And 2 more"_s) &&
                     notice.endsWith(u"Taken from the card: hostname."_s),
                 qPrintable(notice));
        QCOMPARE(start.notes(), QStringList({u"campanel.toml refused"_s, u"hostname done"_s,
                                             u"half.json refused"_s, u"other.json refused"_s}));
    }

    void withoutACardThereIsNothingToSay()
    {
        const QTemporaryDir folder;
        Start start(folder);
        start.open();
        QCOMPARE(start.files.notice(), QString());
        QCOMPARE(start.notes(), QStringList());
    }
};

CAMPANEL_TEST(TestBuilderFiles)

} // namespace campanel::panel::test_builder_files

#include "test_builder_files.moc"
