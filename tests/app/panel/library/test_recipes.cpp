// SPDX-License-Identifier: Apache-2.0
// The recipes as seen by QML, on a database of their own.
#include "app/panel/library/recipes.h"
#include "tests/app/panel/panel_rig.h"

#include "app/store/recipes/recipe_json.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>

namespace campanel::panel::test_recipes {

using test::PanelRig;

namespace {

struct RecipesRig : PanelRig {
    Recipes recipes{machine, editor, records, folder.path(), nullptr};

    RecipesRig()
    {
        recipes.setWallClock([] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7)); });
        machine.accessCheck().setLevel(Level::Service, QStringLiteral("Anna"));
        records.open();
        if (!QTest::qWaitFor([this] { return recipes.total() == 1; }))
            qFatal("the database was not read");
    }

    [[nodiscard]] QStringList names()
    {
        QStringList found;
        for (const RecipeRow& row : recipes.list()->rows())
            found << QStringLiteral("%1 v%2").arg(row.name).arg(row.version);
        return found;
    }
    void choose(const QString& name)
    {
        for (int row = 0; row < recipes.list()->count(); ++row) {
            if (recipes.list()->rows()[row].name == name)
                recipes.choose(row);
        }
    }
    void create(const QString& name)
    {
        const int before = recipes.total();
        recipes.setWantedName(name);
        recipes.create(1);
        QTRY_COMPARE(recipes.total(), before + 1);
    }
};

} // namespace

class TestRecipes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::C); }

    void beginsWithTheRecipeOfThePanel()
    {
        RecipesRig rig;
        QCOMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v1")});
        QVERIFY(rig.recipes.ready());
        QVERIFY(rig.recipes.chosenIsOpen());
        QCOMPARE(rig.recipes.list()->rows().first().summary, QStringLiteral("250.0 mm · 60.0 bags/min"));
        QVERIFY(rig.recipes.chosenNote().contains(QStringLiteral("by Anna")));
    }

    void windowsAreADraftUntilTheyAreStored()
    {
        RecipesRig rig;
        RecipeWindows& windows = *rig.recipes.windows();
        windows.begin();
        QVERIFY(!windows.isTouched());
        QVERIFY(!windows.row(profile::Field::KnifeRadius));
        RecipeWindow& rate = *windows.row(profile::Field::Rate);
        QCOMPARE(rate.present(), QStringLiteral("60.0 bags/min"));
        QCOMPARE(rate.lowest()->text(), QStringLiteral("--"));
        rate.lowest()->set(55);
        QCOMPARE(rate.highest()->value(), profile::info(profile::Field::Rate).max);
        rate.highest()->set(50);
        QCOMPARE(windows.problem(),
                 QStringLiteral("Rate: the lowest value is above the highest. Correct one of them."));
        windows.store();
        rate.highest()->set(1e9); // beyond the limits of the keypad
        QCOMPARE(rate.highest()->value(), 50.0);
        rate.highest()->set(70);
        QCOMPARE(windows.problem(), QString());
        rig.machine.accessCheck().setLevel(Level::Operator);
        windows.store();
        QVERIFY(windows.isTouched());
        rig.machine.accessCheck().setLevel(Level::Technician, QStringLiteral("Anna"));
        rig.editor.bagLength()->set(240); // an unsaved edit stays
        windows.store();
        QVERIFY(!windows.isTouched());
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v2")});
        QTRY_VERIFY(!rig.editor.storedRecipe().windows.empty());
        QCOMPARE(rig.editor.recipe().windows.at(profile::Field::Rate).max, 70.0);
        QCOMPARE(rig.editor.bagLength()->value(), 240.0);
        QVERIFY(rig.editor.edited());
        const auto& figures = rig.recipes.figures()->rows();
        QVERIFY(std::ranges::any_of(figures, [](const FigureRow& row) {
            return row.label == QStringLiteral("Approved: Rate") &&
                   row.value == QStringLiteral("55.0 to 70.0 bags/min");
        }));
        // An earlier version has the windows of now.
        rig.recipes.listVersions();
        QTRY_COMPARE(rig.recipes.candidates()->count(), 2);
        rig.recipes.openVersion(1);
        QVERIFY(!rig.editor.storedRecipe().windows.empty());
        QCOMPARE(rig.editor.storedRecipe().version, 1);
        windows.begin();
        windows.row(profile::Field::Rate)->clear();
        windows.store();
        QTRY_VERIFY(rig.editor.storedRecipe().windows.empty());
    }

    void versionsOfAClockThatIsNotSetSaySo()
    {
        RecipesRig rig;
        QVERIFY(!rig.recipes.chosenNote().contains(QStringLiteral("clock")));
        rig.records.setClockState([] { return store::ClockState::NotSet; });
        rig.editor.bagLength()->set(240);
        rig.recipes.save();
        QTRY_VERIFY(rig.recipes.chosenNote().contains(QStringLiteral("clock not set")));
        rig.recipes.listVersions();
        QTRY_COMPARE(rig.recipes.candidates()->count(), 2);
        const auto& rows = rig.recipes.candidates()->rows();
        QVERIFY(rows[0].note.endsWith(QStringLiteral("by Anna · clock not set")));
        QVERIFY(rows[1].note.endsWith(QStringLiteral("by Anna")));
    }

    void savesAnEditAsTheNextVersion()
    {
        RecipesRig rig;
        rig.editor.bagLength()->set(240);
        QVERIFY(rig.editor.edited());
        QCOMPARE(rig.recipes.nextVersion(), 2);
        rig.recipes.save();
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v2")});
        QVERIFY(!rig.editor.edited());
        QCOMPARE(rig.editor.recipeVersion(), 2);
        QCOMPARE(rig.recipes.message(), QStringLiteral("Saved: Biscuit 250, version 2."));
    }

    // A name may look like a place for a value.
    void aNameStaysWhatItIs()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Mix 50%3"));
        QVERIFY(rig.recipes.message().startsWith(QStringLiteral("Mix 50%3 was created")));
        rig.editor.bagLength()->set(240);
        rig.recipes.save();
        QTRY_COMPARE(rig.recipes.message(), QStringLiteral("Saved: Mix 50%3, version 2."));
        rig.recipes.setWantedName(QStringLiteral("Mix %2%1"));
        rig.recipes.saveAs();
        QTRY_COMPARE(rig.recipes.message(), QStringLiteral("Saved: Mix %2%1, version 1."));
        QTRY_COMPARE(rig.recipes.total(), 3);
        rig.recipes.listOthers();
        rig.recipes.compareOther(0);
        QCOMPARE(rig.recipes.beforeTitle(), QStringLiteral("Mix %2%1 · v1"));
    }

    // During a drag the list of all recipes is not updated.
    void changesAreNotedForTheAuditTrail()
    {
        RecipesRig rig;
        QSignalSpy noted(&rig.recipes, &Recipes::noted);
        const auto last = [&] { return noted.last().first().value<store::AuditEntry>(); };
        rig.editor.bagLength()->set(240);
        rig.recipes.save();
        QTRY_COMPARE(noted.count(), 1);
        QCOMPARE(last().what, QStringLiteral("recipe.save"));
        QCOMPARE(last().object, QStringLiteral("Biscuit 250"));
        QVERIFY2(last().before.startsWith(QStringLiteral("version 1: ")) &&
                     last().before.contains(QStringLiteral("bag_length_mm 250")),
                 qPrintable(last().before));
        QVERIFY2(last().after.startsWith(QStringLiteral("version 2: ")) &&
                     last().after.contains(QStringLiteral("bag_length_mm 240")),
                 qPrintable(last().after));
        QVERIFY(!last().after.contains(QStringLiteral("law")));
        QCOMPARE(last().readBack, QStringLiteral("version 2"));

        rig.create(QStringLiteral("Soap"));
        QCOMPARE(noted.count(), 2);
        QCOMPARE(last().what, QStringLiteral("recipe.new"));
        QCOMPARE(last().object, QStringLiteral("Soap"));
        rig.recipes.setWantedName(QStringLiteral("Hand soap"));
        rig.recipes.rename();
        QTRY_COMPARE(noted.count(), 3);
        QCOMPARE(last().what, QStringLiteral("recipe.rename"));
        QCOMPARE(last().before, QStringLiteral("Soap"));
        QCOMPARE(last().after, QStringLiteral("Hand soap"));
        QTRY_COMPARE(rig.recipes.chosenName(), QStringLiteral("Hand soap"));
        rig.recipes.remove();
        QTRY_COMPARE(noted.count(), 4);
        QCOMPARE(last().what, QStringLiteral("recipe.delete"));
        rig.recipes.restore();
        QTRY_COMPARE(noted.count(), 5);
        QCOMPARE(last().what, QStringLiteral("recipe.restore"));
        QCOMPARE(last().object, QStringLiteral("Hand soap"));
        QCOMPARE(rig.recipes.message(), QStringLiteral("Hand soap is in the list again."));
    }

    void isNotMadeAnewByEachStepOfAnEdit()
    {
        RecipesRig rig;
        QSignalSpy shown(&rig.recipes, &Recipes::listChanged);
        rig.editor.dragRatio(0, 0.26);
        QCOMPARE(shown.size(), 1); // now being edited
        QCOMPARE(rig.recipes.nextVersion(), 2);
        for (const double timeS : {0.27, 0.28, 0.29})
            rig.editor.dragRatio(0, timeS);
        rig.editor.commitDrag();
        QCOMPARE(shown.size(), 1);
        rig.editor.undo();
        QCOMPARE(shown.size(), 2);
        QCOMPARE(rig.recipes.nextVersion(), 1);
    }

    void aDownloadIsAVersionToo()
    {
        RecipesRig rig;
        rig.connectRunning();
        rig.editor.bagLength()->set(245);
        rig.editor.download();
        const program::ProgramImage sent = rig.image();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Active;
        report.crc = sent.crc;
        emit rig.link.downloadReported(report);
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v2")});
        QVERIFY(!rig.editor.edited());
    }

    void createsCopiesAndOpens()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Rusk 310"));
        QCOMPARE(rig.editor.recipeName(), QStringLiteral("Rusk 310"));
        QVERIFY(!rig.editor.edited());
        rig.choose(QStringLiteral("Biscuit 250"));
        QVERIFY(!rig.recipes.chosenIsOpen());
        rig.recipes.open();
        QCOMPARE(rig.editor.recipeName(), QStringLiteral("Biscuit 250"));
        QVERIFY(!rig.editor.canUndo());
        rig.recipes.setWantedName(QStringLiteral("Biscuit copy"));
        rig.recipes.copy();
        QTRY_COMPARE(rig.recipes.total(), 3);
        QCOMPARE(rig.editor.recipeName(), QStringLiteral("Biscuit copy"));
        QCOMPARE(rig.recipes.chosenName(), QStringLiteral("Biscuit copy"));
    }

    void refusesNames_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("isTaken");
        QTest::newRow("good") << QStringLiteral("Wafer 90") << true;
        QTest::newRow("empty") << QString() << false;
        QTest::newRow("only spaces") << QStringLiteral("   ") << false;
        QTest::newRow("same in capitals") << QStringLiteral("BISCUIT 250") << false;
        QTest::newRow("32 letters") << QString(32, u'x') << true;
        QTest::newRow("33 letters") << QString(33, u'x') << false;
        QTest::newRow("11 Chinese letters") << QString(11, QChar(0x82CF)) << false;
    }
    void refusesNames()
    {
        QFETCH(QString, name);
        QFETCH(bool, isTaken);
        RecipesRig rig;
        rig.recipes.setWantedName(name);
        QCOMPARE(rig.recipes.nameProblem().isEmpty(), isTaken);
        rig.recipes.copy();
        rig.recipes.reload();
        QSignalSpy changed(&rig.recipes, &Recipes::listChanged);
        QVERIFY(changed.wait());
        QTRY_COMPARE(rig.recipes.total(), isTaken ? 2 : 1);
    }

    // The machine data does not belong to the recipe: this machine's data stays with any recipe.
    void opensForThisMachine()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Rusk 310"));
        rig.editor.item(profile::Field::KnifeRadius)->set(75);
        rig.recipes.save();
        QTRY_VERIFY(!rig.editor.edited());
        rig.choose(QStringLiteral("Biscuit 250"));
        QTRY_COMPARE(rig.recipes.chosenName(), QStringLiteral("Biscuit 250"));
        rig.recipes.reload();
        QSignalSpy changed(&rig.recipes, &Recipes::listChanged);
        QVERIFY(changed.wait());
        rig.recipes.open();
        QCOMPARE(rig.editor.recipe().machine.knifeRadiusMm, 75.0);
        QVERIFY(!rig.editor.edited());
    }

    // The shortest bag at its rate heats the motor the most.
    void namesTheRecipeWithTheHighestTorque()
    {
        RecipesRig rig;
        const auto figure = [&rig](const QString& label) {
            for (const FigureRow& row : rig.recipes.figures()->rows()) {
                if (row.label == label)
                    return row.value;
            }
            return QString();
        };
        QVERIFY(figure(QStringLiteral("RMS motor torque")).isEmpty());
        rig.editor.item(profile::Field::Inertia)->set(10);
        rig.editor.item(profile::Field::Friction)->set(0.1);
        rig.recipes.save();
        QTRY_COMPARE(figure(QStringLiteral("RMS motor torque")), QStringLiteral("0.101 Nm"));
        QCOMPARE(figure(QStringLiteral("Peak motor torque")), QStringLiteral("0.133 Nm"));
        QVERIFY(figure(QStringLiteral("Highest RMS torque")).isEmpty()); // of one recipe
        rig.create(QStringLiteral("Short"));
        rig.editor.bagLength()->set(100);
        rig.recipes.save();
        QTRY_COMPARE(rig.names().first(), QStringLiteral("Short v2"));
        rig.choose(QStringLiteral("Biscuit 250"));
        QVERIFY2(figure(QStringLiteral("Highest RMS torque")).startsWith(QStringLiteral("Short, ")),
                 qPrintable(figure(QStringLiteral("Highest RMS torque"))));
    }

    void comparesVersionsAndRecipes()
    {
        RecipesRig rig;
        for (const double lengthMm : {240.0, 230.0}) {
            rig.editor.bagLength()->set(lengthMm);
            rig.recipes.save();
            QTRY_VERIFY(!rig.editor.edited());
        }
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v3")});
        rig.recipes.listVersions();
        QTRY_COMPARE(rig.recipes.candidates()->count(), 3);
        rig.recipes.compareVersion(1, false); // version 2 with version 1
        QCOMPARE(rig.recipes.beforeTitle(), QStringLiteral("Version 1"));
        const auto bagLength = [&rig] {
            for (const DifferenceRow& row : rig.recipes.differences()->rows()) {
                if (row.name == QStringLiteral("Bag length"))
                    return row.activeText + QStringLiteral(" to ") + row.editedText;
            }
            return QString();
        };
        QCOMPARE(bagLength(), QStringLiteral("250.0 mm to 240.0 mm"));
        rig.recipes.compareVersion(2, true); // version 1 with the newest
        QCOMPARE(bagLength(), QStringLiteral("250.0 mm to 230.0 mm"));
        rig.recipes.compareVersion(2, false);
        QVERIFY(!rig.recipes.compared());
        // An older version that is opened and edited becomes the newest, not a second one with its number.
        rig.recipes.openVersion(2);
        QCOMPARE(rig.editor.recipeVersion(), 1);
        rig.editor.bagLength()->set(235);
        QCOMPARE(rig.recipes.nextVersion(), 4);
    }

    void renamesWhatIsOpenWithItsEdits()
    {
        RecipesRig rig;
        rig.editor.bagLength()->set(240);
        rig.recipes.setWantedName(QStringLiteral("Biscuit large"));
        rig.recipes.rename();
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit large v1")});
        QCOMPARE(rig.editor.recipeName(), QStringLiteral("Biscuit large"));
        QVERIFY(rig.editor.edited());
        QCOMPARE(rig.editor.bagLength()->value(), 240.0);
    }

    void deletesAndBringsBack()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Rusk 310"));
        rig.choose(QStringLiteral("Biscuit 250"));
        rig.recipes.remove();
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Rusk 310 v1")});
        QVERIFY(rig.recipes.canRestore());
        rig.recipes.restore();
        QTRY_COMPARE(rig.recipes.total(), 2);
        QCOMPARE(rig.recipes.chosenName(), QStringLiteral("Biscuit 250"));
        QVERIFY(!rig.recipes.canRestore());
    }

    void searches()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Rusk 310"));
        rig.recipes.setSearch(QStringLiteral("rUsK"));
        QCOMPARE(rig.names(), QStringList{QStringLiteral("Rusk 310 v1")});
        QCOMPARE(rig.recipes.total(), 2);
        rig.recipes.setSearch(QStringLiteral("pretzel"));
        QCOMPARE(rig.recipes.chosen(), -1);
    }

    void importsFilesAndRefusesBadOnes()
    {
        RecipesRig rig;
        const auto write = [&rig](const char* name, const QByteArray& bytes) {
            QDir(rig.folder.path()).mkpath(QStringLiteral("recipes"));
            QFile file(rig.folder.filePath(QStringLiteral("recipes/") + QString::fromLatin1(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
        };
        program::Recipe good;
        good.name = "Rusk 310";
        good.version = 7;
        good.machine.knifeRadiusMm = 99;
        write("good.json", store::toJson(good));
        write("bad.json", "{\"format\": \"something else\"}");
        rig.recipes.files()->scan();
        QTRY_COMPARE(rig.recipes.files()->files()->count(), 2);
        int usable = -1;
        for (int row = 0; row < 2; ++row) {
            const OfferRow& offer = rig.recipes.files()->files()->rows()[row];
            if (offer.usable)
                usable = row;
            else
                QVERIFY(offer.detail.contains(QStringLiteral("Correct the file")));
            rig.recipes.files()->take(row);
        }
        QVERIFY(usable >= 0);
        QTRY_COMPARE(rig.recipes.total(), 2);
        QCOMPARE(rig.recipes.chosenName(), QStringLiteral("Rusk 310"));
        QVERIFY(rig.recipes.message().contains(QStringLiteral("version 7")));
        rig.recipes.open();
        QCOMPARE(rig.editor.recipe().machine.knifeRadiusMm, 60.0); // from this machine
    }

    // Letters that no font of the panel has would be boxes without a word.
    void aNameThatCannotBeShownIsSaid()
    {
        RecipesRig rig;
        rig.recipes.files()->setGlyphs([](char32_t letter) { return letter < 0x600; });
        QVERIFY(QDir(rig.folder.path()).mkpath(QStringLiteral("recipes")));
        for (const QString& name : {QStringLiteral("Rusk 310"), QStringLiteral("خبز 5")}) {
            program::Recipe recipe;
            recipe.name = name.toStdString();
            QFile file(rig.folder.filePath(QStringLiteral("recipes/offer.json")));
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
            file.write(store::toJson(recipe));
            file.close();
            rig.recipes.files()->scan();
            QTRY_VERIFY(!rig.recipes.files()->busy());
            const OfferRow row = rig.recipes.files()->files()->rows().value(0);
            QVERIFY(row.usable);
            QCOMPARE(row.detail.contains(QStringLiteral("missing: 3.")), name != QStringLiteral("Rusk 310"));
        }
    }

    // A signed recipe needs no technician, but must be newer, of the same kind, and feasible here.
    void importsWhatIsSigned()
    {
        RecipesRig rig;
        const auto key = store::newSigningKey(QStringLiteral("Plant")).value();
        const auto put = [&rig](const QString& name, const QByteArray& bytes) {
            QVERIFY(QDir().mkpath(QFileInfo(rig.folder.filePath(name)).path()));
            QFile file(rig.folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        };
        put(QStringLiteral("keys/plant.json"), store::publicKeyFile(key));
        rig.recipes.files()->setKeyFolder(rig.folder.filePath(QStringLiteral("keys")));
        QSignalSpy noted(&rig.recipes, &Recipes::noted);
        const auto offer = [&](const program::Recipe& recipe) {
            const auto before = noted.count();
            put(QStringLiteral("recipes/offer.json"), store::signRecipe(recipe, 1'790'000'000'000, 1, key));
            rig.recipes.files()->scan();
            if (!QTest::qWaitFor([&] { return !rig.recipes.files()->busy(); }))
                qFatal("the folder was not searched");
            const OfferRow row = rig.recipes.files()->files()->rows().value(0);
            rig.recipes.files()->take(0);
            if (row.usable && !QTest::qWaitFor([&] { return noted.count() > before; }))
                qFatal("the offer was not imported");
            return row;
        };
        program::Recipe recipe = rig.editor.storedRecipe();
        recipe.version = 8;
        program::setValue(recipe, profile::Field::BagLength, 240);
        rig.machine.accessCheck().setLevel(Level::Operator);
        OfferRow row = offer(recipe);
        QVERIFY2(row.usable && row.note.contains(QStringLiteral("signed by Plant")), qPrintable(row.note));
        QVERIFY2(row.detail.contains(QStringLiteral("version 8")) &&
                     row.detail.contains(QStringLiteral("250.0 mm to 240.0 mm")),
                 qPrintable(row.detail));
        QTRY_COMPARE(rig.names(), QStringList{QStringLiteral("Biscuit 250 v8")});
        QCOMPARE(noted.last().first().value<store::AuditEntry>().readBack,
                 QStringLiteral("version 8, signed by Plant"));

        const auto imports = noted.count();
        recipe.version = 7; // a replay of an older offer
        row = offer(recipe);
        QVERIFY2(!row.usable && row.detail.contains(QStringLiteral("older version")), qPrintable(row.detail));
        recipe.version = 9;
        program::setValue(recipe, profile::Field::Rate, 590);
        row = offer(recipe);
        QVERIFY2(!row.usable && row.detail.contains(QStringLiteral("cannot run the recipe")),
                 qPrintable(row.detail));
        program::Recipe move = rig.editor.newRecipe(profile::ProgramKind::PositionMove);
        move.name = recipe.name;
        move.version = 9;
        row = offer(move);
        QVERIFY2(!row.usable && row.detail.contains(QStringLiteral("Rename")), qPrintable(row.detail));
        QCOMPARE(noted.count(), imports);

        rig.machine.accessCheck().setLevel(Level::Viewer);
        QSignalSpy refused(&rig.machine.accessCheck(), &AccessCheck::refused);
        recipe = rig.editor.storedRecipe();
        recipe.version = 10;
        put(QStringLiteral("recipes/offer.json"), store::signRecipe(recipe, 1'790'000'000'000, 1, key));
        rig.recipes.files()->scan();
        QTRY_VERIFY(!rig.recipes.files()->busy());
        rig.recipes.files()->take(0);
        QCOMPARE(refused.count(), 1);
        QCOMPARE(refused.last().first().value<Level>(), Level::Operator);
    }

    void exportsWhatCanBeImported()
    {
        RecipesRig rig;
        rig.create(QStringLiteral("Rusk 310"));
        rig.recipes.exports()->setScanner([](const QString& folder) {
            return QList<store::Place>{{folder, QStringLiteral("STICK"), false, true}};
        });
        QDir(rig.folder.path()).mkpath(QStringLiteral("recipes"));
        rig.recipes.offerExport(true);
        QTRY_VERIFY(!rig.recipes.exports()->busy());
        rig.recipes.exports()->write(0);
        QTRY_VERIFY(!rig.recipes.exports()->message().isEmpty());
        QVERIFY2(!rig.recipes.exports()->failed(), qPrintable(rig.recipes.exports()->message()));
        QVERIFY(rig.recipes.exports()->message().contains(QStringLiteral("remove the stick")));
        const auto read = store::readRecipe(rig.folder.filePath(QStringLiteral("recipes/Rusk 310.json")));
        QVERIFY(read);
        QCOMPARE(read->name, std::string("Rusk 310"));
    }

    void survivesARestart()
    {
        PanelRig rig;
        for (int start = 0; start < 2; ++start) {
            DatabaseService records(rig.folder.path(), nullptr);
            Recipes recipes(rig.machine, rig.editor, records, rig.folder.path(), nullptr);
            records.open();
            QTRY_COMPARE(recipes.total(), start + 1);
            recipes.setWantedName(QStringLiteral("Number %1").arg(start));
            recipes.copy();
        }
    }

    // The panel starts with version 1 open while the library has a version 2, as after an import.
    void aRestartDoesNotMakeAnOldVersionTheNewest()
    {
        PanelRig rig;
        for (int start = 0; start < 2; ++start) {
            DatabaseService records(rig.folder.path(), nullptr);
            Recipes recipes(rig.machine, rig.editor, records, rig.folder.path(), nullptr);
            records.open();
            QTRY_COMPARE(recipes.total(), 1);
            program::Recipe next = rig.editor.storedRecipe();
            next.cutter().bagLengthMm = 260;
            next.version = 2;
            int version = 0;
            records.store().run(
                &recipes,
                [next, start](store::Database& database) {
                    store::RecipeLibrary library(database);
                    return start == 0 ? library.save(next, {}, 1)
                                      : library.newest().map([](const auto& all) { return all.first(); });
                },
                [&version](const auto& saved) { version = saved ? saved->version : -1; });
            QTRY_COMPARE(version, 2);
        }
    }
};

CAMPANEL_TEST(TestRecipes)

} // namespace campanel::panel::test_recipes

#include "test_recipes.moc"
