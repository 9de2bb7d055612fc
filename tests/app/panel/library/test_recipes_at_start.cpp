// SPDX-License-Identifier: Apache-2.0
// A start whose files were lost or damaged: no default takes the place of recipes and machine data.
#include "app/panel/library/recipes.h"
#include "tests/app/panel/panel_rig.h"

#include "app/store/recipes/recipe_json.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

namespace campanel::panel::test_recipes_at_start {

using namespace Qt::StringLiterals;

namespace {

constexpr double pulsesSet = 20'000; // by a person; the default is 10 000

// The panel's recipes on the files of a folder, once per start.
struct Start {
    test::FakeLink link;
    Settings settings;
    Controller machine{link, settings, nullptr};
    Editor editor;
    DatabaseService records;
    Recipes recipes;
    QSignalSpy noted{&recipes, &Recipes::noted};

    explicit Start(const QTemporaryDir& folder)
        : Start(folder.path())
    {
    }
    explicit Start(const QString& folder)
        : settings(QDir(folder).filePath(u"settings.ini"_s), nullptr)
        , editor(machine, folder, nullptr)
        , records(folder, nullptr)
        , recipes(machine, editor, records, folder, nullptr)
    {
        records.open();
        settle();
    }
    // Waits until the questions of the start, and those that follow from their answers, are answered.
    void settle()
    {
        for (int round = 0; round < 6; ++round) {
            bool isDone = false;
            records.store().run(
                &recipes, [](store::Database&) { return true; }, [&isDone](bool) { isDone = true; });
            if (!QTest::qWaitFor([&isDone] { return isDone; }))
                qFatal("the database does not answer");
        }
    }
    double pulses() { return editor.recipe().machine.pulsesPerMotorRev; }
    double pulsesOfDatabase()
    {
        double found = 0;
        records.store().run(
            &recipes, [](store::Database& database) { return store::RecipeLibrary(database).machines(); },
            [&found](const auto& all) { found = all ? all->first().recipe.machine.pulsesPerMotorRev : -1; });
        settle();
        return found;
    }
    QStringList names()
    {
        QStringList found;
        for (const RecipeRow& row : recipes.list()->rows())
            found << u"%1 v%2"_s.arg(row.name).arg(row.version);
        return found;
    }
    QStringList notes()
    {
        QStringList found;
        for (const auto& each : noted)
            found << each.first().value<store::AuditEntry>().what;
        return found;
    }
};

// Saves the recipe Soap on a machine with pulsesSet.
void saveSoap(const QTemporaryDir& folder)
{
    Start start{test::withStoredRecipe(folder.path())};
    start.editor.item(profile::Field::PulsesPerMotorRev)->set(pulsesSet);
    start.recipes.setWantedName(u"Soap"_s);
    start.recipes.saveAs();
    start.settle();
}

void damage(const QString& path)
{
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write("{");
}

} // namespace

class TestRecipesAtStart : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::C); }

    void aNewPanelStoresNothingBeforeSomebodySaves()
    {
        const QTemporaryDir folder;
        for (int i = 0; i < 2; ++i) {
            Start start(folder);
            QCOMPARE(start.names(), QStringList());
            QCOMPARE(start.editor.notice(), QString());
            QCOMPARE(start.editor.recipeVersion(), 0);
            QVERIFY(start.editor.edited());
            start.editor.bagLength()->set(180);
            QCOMPARE(start.editor.recipeName(), u"Bag 180"_s);
        }
        {
            Start start(folder);
            QCOMPARE(start.editor.bagLength()->value(), 180.0);
            QCOMPARE(start.editor.recipeName(), u"Bag 180"_s);
            start.editor.bagLength()->set(190.5);
            start.recipes.save();
            start.settle();
            QCOMPARE(start.names(), QStringList{u"Bag 190.5 v1"_s});
            QCOMPARE(start.editor.recipeVersion(), 1);
            QVERIFY(!start.editor.edited());
            start.editor.bagLength()->set(200); // the name is that of a saved recipe now
            QCOMPARE(start.editor.recipeName(), u"Bag 190.5"_s);
        }
        Start start(folder);
        QCOMPARE(start.names(), QStringList{u"Bag 190.5 v1"_s});
    }

    void theProposedNameIsInTheShownUnit()
    {
        const QTemporaryDir folder;
        {
            Start start(folder);
            start.settings.set("display.units", u"inch"_s);
            start.editor.bagLength()->set(180 / 25.4);
            QCOMPARE(start.editor.recipeName(), u"Bag 7.087 in"_s);
        }
        Start start(folder);
        start.settings.set("display.units", u"metric"_s);
        start.editor.bagLength()->set(190); // nobody has typed the name yet
        QCOMPARE(start.editor.recipeName(), u"Bag 190"_s);
        start.recipes.save();
        start.settle();
        start.settings.set("display.units", u"inch"_s);
        start.editor.bagLength()->set(8);
        QCOMPARE(start.editor.recipeName(), u"Bag 190"_s); // the name of a saved recipe stays
        start.settings.set("display.units", u"metric"_s);
    }

    void aTypedNameFollowsNothing()
    {
        const QTemporaryDir folder;
        {
            Start start(folder);
            start.recipes.setWantedName(u"Soap"_s);
            start.recipes.rename(); // as in the first start
            start.editor.bagLength()->set(180);
            QCOMPARE(start.editor.recipeName(), u"Soap"_s);
        }
        Start start(folder);
        start.editor.bagLength()->set(190);
        QCOMPARE(start.editor.recipeName(), u"Soap"_s);
        start.recipes.save();
        start.settle();
        QCOMPARE(start.names(), QStringList{u"Soap v1"_s});
    }

    // A panel of today already holds the default recipe.
    void theDefaultOfAnOldPanelOpensAsBefore()
    {
        const QTemporaryDir folder;
        for (int i = 0; i < 2; ++i) {
            Start start{test::withStoredRecipe(folder.path())};
            QCOMPARE(start.names(), QStringList{u"Biscuit 250 v1"_s});
            QCOMPARE(start.editor.notice(), QString());
            QVERIFY(!start.editor.edited());
            QCOMPARE(start.editor.recipeVersion(), 1);
        }
    }

    void aRecipeOfWhichNothingCanBeReadIsNamed()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        {
            Start start(folder);
            start.recipes.setWantedName(u"Rusk"_s);
            start.recipes.saveAs();
            start.settle();
        }
        {
            const auto database = *store::Database::open(folder.path());
            QVERIFY(database->execute(
                u"UPDATE recipe_version SET json = '{' WHERE recipe = (SELECT id FROM recipe WHERE name = 'Soap')"_s));
        }
        Start start(folder);
        QVERIFY2(start.recipes.message().startsWith(u"No version of these recipes can be read: Soap."),
                 qPrintable(start.recipes.message()));
        QCOMPARE(start.names(), QStringList({u"Rusk v1"_s, u"Biscuit 250 v1"_s}));
        // The open recipe has its own file and is kept again.
        QVERIFY(!start.recipes.message().contains(u"Rusk"));
    }

    void noDefaultTakesThePlaceOfLostFiles_data()
    {
        QTest::addColumn<bool>("isWorkingCopyThere");
        QTest::addColumn<bool>("isDamaged");
        QTest::addRow("lost") << false << false;
        QTest::addRow("damaged") << false << true;
        QTest::addRow("lost, the working copy is there") << true << false;
        QTest::addRow("damaged, the working copy is there") << true << true;
    }

    void noDefaultTakesThePlaceOfLostFiles()
    {
        QFETCH(bool, isWorkingCopyThere);
        QFETCH(bool, isDamaged);
        const QTemporaryDir folder;
        saveSoap(folder);
        QStringList files{u"recipe.json"_s, u"recipe.json.bak"_s};
        if (!isWorkingCopyThere)
            files << u"working_copy.json"_s << u"working_copy.json.bak"_s;
        for (const QString& each : files) {
            if (isDamaged)
                damage(folder.filePath(each));
            else
                QFile::remove(folder.filePath(each));
        }
        Start start(folder);
        QCOMPARE(start.pulsesOfDatabase(), pulsesSet);
        QCOMPARE(start.editor.storedRecipe().name, std::string("Soap"));
        QCOMPARE(start.pulses(), pulsesSet);
        QVERIFY(!start.editor.edited());
        QCOMPARE(start.names(), (QStringList{u"Soap v1"_s, u"Biscuit 250 v1"_s}));
        QVERIFY2(start.editor.notice().contains(u"Opened instead: Soap, version 1"_s),
                 qPrintable(start.editor.notice()));
        QCOMPARE(start.notes(), QStringList{u"recipe.file_lost"_s});
        start.editor.newProgram(static_cast<int>(Editor::Kind::RotaryCutter));
        QCOMPARE(start.pulses(), pulsesSet);
    }

    void editsOutliveTheLostFile()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        {
            Start start(folder);
            start.editor.bagLength()->set(240);
        }
        QFile::remove(folder.filePath(u"recipe.json"_s));
        QFile::remove(folder.filePath(u"recipe.json.bak"_s));
        Start start(folder);
        QCOMPARE(start.editor.storedRecipe().cutter().bagLengthMm, 250.0);
        QCOMPARE(start.editor.recipe().cutter().bagLengthMm, 240.0);
        QVERIFY(start.editor.edited());
    }

    // The last good copy is of the time before the machine data were set.
    void anOlderCopyBringsNoMachineDataBack()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        QFile::remove(folder.filePath(u"recipe.json.bak"_s));
        QVERIFY(store::writeRecipe(program::Recipe{}, folder.filePath(u"recipe.json.bak"_s)));
        damage(folder.filePath(u"recipe.json"_s));
        Start start(folder);
        QCOMPARE(start.editor.storedRecipe().name, std::string("Soap"));
        QCOMPARE(start.pulses(), pulsesSet);
        QCOMPARE(start.pulsesOfDatabase(), pulsesSet);
    }

    void aDamagedWorkingCopyIsNoEdit()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        damage(folder.filePath(u"working_copy.json"_s));
        QFile::remove(folder.filePath(u"working_copy.json.bak"_s));
        Start start(folder);
        QCOMPARE(start.editor.recipe().name, std::string("Soap"));
        QVERIFY(!start.editor.edited());
        QVERIFY2(start.editor.notice().startsWith(u"The unsaved edits were lost"_s),
                 qPrintable(start.editor.notice()));
    }

    void damagedMachineDataComeFromTheNewestRecipe()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        for (const QString& harm : {u"UPDATE machine_data SET json = '{'"_s, u"DELETE FROM machine_data"_s}) {
            Start before(folder);
            before.records.store().run(
                &before.recipes,
                [harm](store::Database& database) { return database.execute(harm).has_value(); },
                [](bool isDone) { QVERIFY(isDone); });
            before.settle();
            Start start(folder);
            start.editor.newProgram(static_cast<int>(Editor::Kind::RotaryCutter));
            QCOMPARE(start.pulses(), pulsesSet);
            QVERIFY2(start.editor.notice().contains(u"recipe Soap are used"_s),
                     qPrintable(start.editor.notice()));
            QCOMPARE(start.notes(), QStringList{u"recipe.machine_lost"_s});
            start.editor.undo();
        }
    }

    // An old recipe was saved with the machine data of its time.
    void aCodeOfAnOldRecipeChangesNoMachineData()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        Start start(folder);
        start.recipes.chooseId(start.recipes.coded(u"Biscuit 250"_s).first().recipeId);
        QVERIFY(start.recipes.chosenRecipe()->recipe.machine.pulsesPerMotorRev != pulsesSet);
        start.recipes.codes()->enter(RecipeCodes::Code::Film);
        start.recipes.codes()->setWanted(u"PE 30"_s);
        start.recipes.codes()->store();
        start.settle();
        QCOMPARE(start.recipes.codes()->filmText(), u"PE 30"_s);
        QCOMPARE(start.pulsesOfDatabase(), pulsesSet);
    }

    // All recipes are deleted: the machine is still what it was.
    void anEmptyListKeepsTheMachine()
    {
        const QTemporaryDir folder;
        saveSoap(folder);
        {
            Start start(folder);
            while (start.recipes.total() > 0) {
                start.recipes.choose(0);
                start.recipes.remove();
                start.settle();
            }
        }
        for (const auto* each :
             {"recipe.json", "recipe.json.bak", "working_copy.json", "working_copy.json.bak"})
            QFile::remove(folder.filePath(QString::fromLatin1(each)));
        Start start(folder);
        QCOMPARE(start.pulses(), pulsesSet);
        QCOMPARE(start.pulsesOfDatabase(), pulsesSet);
        QCOMPARE(start.recipes.total(), 0);
    }
};

CAMPANEL_TEST(TestRecipesAtStart)

} // namespace campanel::panel::test_recipes_at_start

#include "test_recipes_at_start.moc"
