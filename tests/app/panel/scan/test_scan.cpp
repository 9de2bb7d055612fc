// SPDX-License-Identifier: Apache-2.0
// What a scanned code does on the panel: the recipe, its codes, the decision on edits, and the sentences.
#include "app/panel/scan/scan.h"
#include "tests/app/panel/panel_rig.h"

#include "app/panel/library/recipes.h"
#include "app/store/recipes/recipe_json.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>

namespace campanel::panel::test_scan {

using namespace Qt::StringLiterals;

namespace {

struct ScanRig : test::PanelRig {
    Recipes recipes{machine, editor, records, folder.path(), nullptr};
    Scan scan{{machine, editor, recipes, settings}, folder.path(), nullptr};
    QSignalSpy opened{&scan, &Scan::recipeOpened};
    QSignalSpy edits{&scan, &Scan::editsFound};

    ScanRig()
    {
        records.open();
        if (!QTest::qWaitFor([this] { return recipes.total() == 1; }))
            qFatal("the database was not read");
        recipes.setWantedName(u"Soap"_s);
        recipes.create(1);
        if (!QTest::qWaitFor([this] { return recipes.total() == 2 && !editor.edited(); }))
            qFatal("no second recipe");
    }
    void choose(const QString& name) { recipes.chooseId(recipes.coded(name).first().recipeId); }
    void setCode(RecipeCodes::Code code, const QString& text)
    {
        recipes.codes()->enter(code);
        recipes.codes()->setWanted(text);
        recipes.codes()->store();
    }
};

} // namespace

class TestScan : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::C); }

    void theNameOfARecipeIsItsCode()
    {
        ScanRig rig;
        QCOMPARE(rig.editor.recipeName(), u"Soap"_s);
        rig.recipes.setSearch(u"So"_s);
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 1);
        QCOMPARE(rig.editor.recipeName(), u"Biscuit 250"_s);
        QCOMPARE(rig.recipes.chosenName(), u"Biscuit 250"_s);
        QVERIFY(rig.recipes.chosen() >= 0);
        QCOMPARE(rig.scan.notice(), QString());
        QVERIFY(rig.link.banks.empty()); // a person downloads
    }

    void aCodeReplacesTheName()
    {
        ScanRig rig;
        rig.choose(u"Biscuit 250"_s);
        QCOMPARE(rig.recipes.codes()->scanText(), u"Biscuit 250"_s);
        QSignalSpy noted(&rig.recipes, &Recipes::noted);
        rig.setCode(RecipeCodes::Code::Recipe, u" 4006381 "_s);
        QTRY_COMPARE(rig.recipes.codes()->scanText(), u"4006381"_s);
        QCOMPARE(rig.recipes.message(), u"Saved: Biscuit 250, version 2."_s);
        QCOMPARE(noted.count(), 1);
        const auto entry = noted.first().first().value<store::AuditEntry>();
        QCOMPARE(entry.after, u"version 2: scan_code 4006381"_s);

        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 0);
        QCOMPARE(
            rig.scan.notice(),
            u"No recipe has the code Biscuit 250. Enter the code with its recipe on the Recipes page."_s);
        rig.scan.takeCode(u"4006381"_s);
        QCOMPARE(rig.opened.count(), 1);
        QCOMPARE(rig.scan.notice(), QString());
        QCOMPARE(rig.editor.recipe().scanCode, std::string("4006381"));
    }

    void theOpenRecipeKeepsItsEditsWhenItsCodeIsSet()
    {
        ScanRig rig;
        rig.editor.bagLength()->set(240);
        rig.choose(u"Soap"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PE 30"_s);
        QVERIFY(rig.editor.edited());
        QCOMPARE(rig.editor.bagLength()->value(), 240.0);
        QCOMPARE(rig.editor.storedRecipe().version, 2);
        QCOMPARE(rig.editor.recipe().filmCode, std::string("PE 30"));
        rig.recipes.save();
        QTRY_VERIFY(!rig.editor.edited());
        QTRY_COMPARE(rig.recipes.chosenRecipe()->recipe.version, 3);
        QCOMPARE(rig.recipes.chosenRecipe()->recipe.filmCode, std::string("PE 30"));
    }

    void aCodeThatIsTakenIsRefusedWithItsOwner()
    {
        ScanRig rig;
        rig.choose(u"Soap"_s);
        RecipeCodes& codes = *rig.recipes.codes();
        codes.enter(RecipeCodes::Code::Recipe);
        codes.setWanted(u"Biscuit 250"_s);
        QCOMPARE(codes.problem(), u"This is the code of the recipe Biscuit 250. Enter another code."_s);
        codes.setWanted(u"Soap"_s);
        QCOMPARE(codes.problem(), QString());
        codes.setWanted(QString(65, u'7'));
        QCOMPARE(codes.problem(), u"The code is too long. Enter at most 64 letters and digits."_s);
        codes.setWanted(u"a\x01z"_s);
        QCOMPARE(codes.problem(),
                 u"The code has characters that cannot be printed. Enter letters and digits."_s);
        codes.enter(RecipeCodes::Code::Film);
        codes.setWanted(u"Soap"_s);
        QCOMPARE(codes.problem(), u"This is the code of the recipe Soap. Enter another code."_s);
    }

    void theCodeOfTwoRecipesOpensNone()
    {
        ScanRig rig;
        program::Recipe recipe = rig.editor.newRecipe(profile::ProgramKind::RotaryCutter);
        recipe.name = "Rusk";
        recipe.scanCode = "Soap"; // from a file
        rig.records.store().run(
            &rig.recipes,
            [recipe](store::Database& database) {
                return store::RecipeLibrary(database).save(recipe, {}, 1);
            },
            [&rig](const auto& /*saved*/) { rig.recipes.reload(); });
        QTRY_COMPARE(rig.recipes.total(), 3);
        rig.scan.takeCode(u"Soap"_s);
        QCOMPARE(rig.opened.count(), 0);
        QVERIFY2(rig.scan.notice().contains(u"have the same code Soap"_s), qPrintable(rig.scan.notice()));
    }

    void editsAreAskedForFirst()
    {
        ScanRig rig;
        rig.editor.bagLength()->set(240);
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.edits.count(), 1);
        QCOMPARE(rig.opened.count(), 0);
        QCOMPARE(rig.editor.recipeName(), u"Soap"_s);
        rig.scan.openScanned(true);
        QCOMPARE(rig.opened.count(), 1);
        QCOMPARE(rig.editor.recipeName(), u"Biscuit 250"_s);
        QTRY_COMPARE(rig.recipes.coded(u"Soap"_s).first().recipe.version, 2);
        QCOMPARE(rig.recipes.coded(u"Soap"_s).first().recipe.cutter().bagLengthMm, 240.0);
    }

    void belowOperatorTheLoginIsRequested()
    {
        ScanRig rig;
        rig.machine.accessCheck().setLevel(Level::Viewer);
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 0);
        QCOMPARE(rig.editor.recipeName(), u"Soap"_s);
    }

    void anEntryTakesTheCode()
    {
        ScanRig rig;
        QSignalSpy read(&rig.scan, &Scan::codeRead);
        rig.scan.beginEntry();
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 0);
        QCOMPARE(read.count(), 1);
        QCOMPARE(rig.scan.lastCode(), u"Biscuit 250"_s);
        rig.scan.endEntry();
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 1);
    }

    void theFirstStartComesFirst()
    {
        ScanRig rig;
        rig.settings.beginFirstStart();
        rig.scan.takeCode(u"Biscuit 250"_s);
        QCOMPARE(rig.opened.count(), 0);
        QCOMPARE(rig.scan.notice(), u"Complete the first start, then scan again."_s);
    }

    void theScannerIsOffUntilAPrefixIsSet()
    {
        ScanRig rig;
        QVERIFY(!rig.scan.isEnabled());
        for (const QString& wrong : {u"a b"_s, u"123456789"_s, u"ä"_s, u"\x02"_s}) {
            QVERIFY(rig.scan.prefixProblem(wrong).startsWith(u"The prefix is not possible."_s));
            rig.scan.setPrefix(wrong);
            QVERIFY(!rig.scan.isEnabled());
        }
        rig.scan.setPrefix(u"~~"_s);
        QVERIFY(rig.scan.isEnabled());
        rig.settings.set("scanner.suffix", u"tab"_s);
        QCOMPARE(rig.settings.values().text("scanner.suffix"), u"tab"_s);
        rig.settings.setting(u"scanner.key_time_ms"_s)->set(5);
        QCOMPARE(rig.settings.setting(u"scanner.key_time_ms"_s)->text(), u"100"_s);
        rig.settings.setting(u"scanner.key_time_ms"_s)->set(50);
        QCOMPARE(rig.settings.setting(u"scanner.key_time_ms"_s)->text(), u"50"_s);
        rig.machine.accessCheck().setLevel(Level::Technician);
        rig.settings.guardBy(rig.machine.accessCheck());
        rig.scan.setPrefix({});
        QVERIFY(rig.scan.isEnabled()); // for the level Service
    }

    void aWrongFilmReelBlocksStart()
    {
        ScanRig rig;
        QSignalSpy noted(rig.scan.film(), &FilmCheck::noted);
        QSignalSpy wrong(&rig.scan, &Scan::wrongFilmScanned);
        const auto last = [&] { return noted.last().first().value<store::AuditEntry>(); };
        rig.choose(u"Biscuit 250"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PP 40"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PP 40"_s);
        rig.choose(u"Soap"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PE 30"_s);
        rig.connectRunning();
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.machine.startBlockedReason(), QString()); // not scanned

        rig.scan.takeCode(u"PP 40"_s);
        const QString sentence =
            u"Wrong film reel: PP 40 was scanned, the recipe needs PE 30. Load and scan the right reel."_s;
        QCOMPARE(rig.machine.startBlockedReason(), sentence);
        const auto permitted = [&rig](modbus::PermitBit bit) {
            return (rig.link.permit & modbus::RegisterInfo::bitOf(bit)) != 0;
        };
        QVERIFY(!permitted(modbus::PermitBit::Film));
        QVERIFY(!permitted(modbus::PermitBit::PanelAgrees));
        QVERIFY(permitted(modbus::PermitBit::Recipe));
        QCOMPARE(wrong.count(), 1);
        QCOMPARE(last().what, u"film.scan"_s);
        QCOMPARE(last().outcome, u"refused"_s);
        rig.machine.start();
        QVERIFY(rig.link.requests.empty());
        {
            FilmCheck restarted(rig.machine, rig.recipes, rig.folder.path(), nullptr);
            QCOMPARE(restarted.blockedReason(), sentence);
        }
        rig.machine.setStartInterlock([&rig] { return rig.scan.film()->blockedReason(); });

        rig.scan.takeCode(u"PE 30"_s);
        QCOMPARE(rig.machine.startBlockedReason(), QString());
        QCOMPARE(rig.link.permit, modbus::allPermits);
        QCOMPARE(rig.scan.notice(), u"Film reel PE 30 is the right one for this recipe."_s);
        QCOMPARE(last().outcome, u"done"_s);

        rig.scan.takeCode(u"PP 40"_s);
        rig.machine.accessCheck().setLevel(Level::Operator);
        rig.scan.film()->overrideCheck(u"no other reel"_s);
        QCOMPARE(rig.machine.startBlockedReason(), sentence);
        rig.machine.accessCheck().setLevel(Level::Technician);
        rig.scan.film()->overrideCheck(u"  "_s);
        QCOMPARE(rig.machine.startBlockedReason(), sentence);
        rig.scan.film()->overrideCheck(u"no other reel"_s);
        QCOMPARE(rig.machine.startBlockedReason(), QString());
        QCOMPARE(last().what, u"film.override"_s);
        QCOMPARE(last().object, u"Soap"_s);
        QCOMPARE(last().before, u"PE 30"_s);
        QCOMPARE(last().after, u"PP 40: no other reel"_s);

        rig.scan.takeCode(u"PP 41"_s); // the override was for another reel
        QCOMPARE(
            rig.machine.startBlockedReason(),
            u"Unknown code PP 41: no recipe and no film reel has it. Load and scan the film reel PE 30."_s);
    }

    // The reel stays on the machine when its program changes.
    void theReelIsComparedWithEachProgram()
    {
        ScanRig rig;
        const auto activate = [&rig] {
            rig.link.activate(rig.image(), rig.now);
            const std::string name = rig.editor.recipeName().toStdString();
            return QTest::qWaitFor([&rig, name] {
                return rig.machine.program() && rig.machine.program()->name == name &&
                       rig.machine.program()->crc == rig.image().crc;
            });
        };
        rig.choose(u"Biscuit 250"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PP 40"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PP 40"_s);
        rig.choose(u"Soap"_s);
        rig.connectRunning();
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        QVERIFY(activate());

        rig.scan.takeCode(u"PP 40"_s); // Soap needs no certain reel
        QCOMPARE(rig.scan.notice(), u"Film reel PP 40 is loaded. The next recipe is compared with it."_s);
        QCOMPARE(rig.machine.startBlockedReason(), QString());
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(
            rig.machine.startBlockedReason(),
            u"Wrong film reel: PP 40 was scanned, the recipe needs PE 30. Load and scan the right reel."_s);
        rig.editor.bagLength()->set(240);
        QVERIFY(activate());
        QVERIFY(!rig.machine.startBlockedReason().isEmpty()); // a changed length is no other film
        rig.scan.film()->overrideCheck(u"same width"_s);
        QCOMPARE(rig.machine.startBlockedReason(), QString());
        rig.editor.bagLength()->set(241);
        QVERIFY(activate());
        QCOMPARE(rig.machine.startBlockedReason(), QString());

        rig.choose(u"Biscuit 250"_s);
        rig.recipes.open();
        QVERIFY(activate());
        QCOMPARE(rig.machine.startBlockedReason(), QString()); // the right one
        rig.scan.takeCode(u"PE 30"_s);
        QVERIFY(!rig.machine.startBlockedReason().isEmpty());
    }

    // A change of the recipe in the library changes nothing on the machine.
    void theReelBelongsToTheProgramInTheController_data()
    {
        QTest::addColumn<QString>("change");
        for (const char* change :
             {"rename", "delete", "capitals", "another film for the next version", "restart"})
            QTest::addRow("%s", change) << QString::fromLatin1(change);
    }

    void theReelBelongsToTheProgramInTheController()
    {
        QFETCH(QString, change);
        ScanRig rig;
        rig.choose(u"Soap"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PE 30"_s);
        rig.connectRunning();
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        rig.scan.takeCode(u"PP 40"_s);
        const QString reason = rig.machine.startBlockedReason();
        QVERIFY2(reason.contains(u"needs PE 30"_s) || reason.contains(u"film reel PE 30"_s),
                 qPrintable(reason));
        const auto save = [&rig](program::Recipe recipe) {
            rig.records.store().run(
                &rig.recipes,
                [recipe](store::Database& database) {
                    return store::RecipeLibrary(database).save(recipe, {}, 1);
                },
                [&rig](const auto& /*saved*/) { rig.recipes.reload(); });
        };
        QSignalSpy listed(&rig.recipes, &Recipes::listChanged);
        if (change == u"rename") {
            rig.recipes.setWantedName(u"Soap 2"_s);
            rig.recipes.rename();
        } else if (change == u"delete") {
            rig.recipes.remove();
        } else if (change == u"capitals") {
            program::Recipe imported = rig.recipes.chosenRecipe()->recipe;
            imported.name = "SOAP";
            imported.filmCode.clear();
            save(imported);
        } else if (change != u"restart") {
            program::Recipe next = rig.recipes.chosenRecipe()->recipe;
            next.version += 1;
            next.filmCode = "PP 40";
            save(next);
        }
        if (change == u"restart") {
            rig.recipes.remove();
            QTRY_COMPARE(rig.recipes.total(), 1);
            {
                FilmCheck restarted(rig.machine, rig.recipes, rig.folder.path(), nullptr);
                QVERIFY(!restarted.blockedReason().isEmpty());
                rig.link.activate(rig.image(), rig.now); // of a recipe that no library has
                QVERIFY(!restarted.blockedReason().isEmpty());
            }
            return;
        }
        QTRY_VERIFY(listed.count() > 0);
        QTRY_VERIFY(rig.recipes.chosenName() != u"Soap"_s || rig.recipes.chosenRecipe()->version > 2);
        QVERIFY2(!rig.machine.startBlockedReason().isEmpty(), qPrintable(change));
        rig.scan.takeCode(u"PE 30"_s);
        QCOMPARE(rig.machine.startBlockedReason(), QString());
    }

    void aFileOfTheReelThatIsDamagedAsksForAScan()
    {
        ScanRig rig;
        rig.choose(u"Soap"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PE 30"_s);
        rig.connectRunning();
        rig.scan.takeCode(u"PE 30"_s);
        QFile file(rig.folder.filePath(u"film_reel.json"_s));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write("{");
        file.close();
        FilmCheck restarted(rig.machine, rig.recipes, rig.folder.path(), nullptr);
        emit rig.recipes.listChanged();
        QVERIFY(restarted.blockedReason().contains(u"Load and scan the film reel PE 30"_s));
    }

    void withoutALoginNoReelIsTaken()
    {
        ScanRig rig;
        rig.choose(u"Soap"_s);
        rig.setCode(RecipeCodes::Code::Film, u"PE 30"_s);
        QTRY_COMPARE(rig.recipes.codes()->filmText(), u"PE 30"_s);
        rig.connectRunning();
        QSignalSpy refused(&rig.machine.accessCheck(), &AccessCheck::refused);
        rig.machine.accessCheck().setLevel(Level::Viewer);
        rig.scan.takeCode(u"PP 40"_s);
        QCOMPARE(refused.count(), 1);
        QCOMPARE(rig.scan.film()->scannedCode(), QString());
        rig.scan.openScanned(true);
        QCOMPARE(refused.count(), 2);
        QCOMPARE(rig.opened.count(), 0);
    }

    void codesAreInTheRecipeFile()
    {
        program::Recipe recipe;
        QVERIFY(!store::toJson(recipe).contains("_code"));
        recipe.scanCode = "4006381";
        recipe.filmCode = "PE 30";
        const auto read = store::fromJson(store::toJson(recipe), {});
        QVERIFY(read);
        QVERIFY(program::sameCodes(*read, recipe));
        QByteArray wrong = store::toJson(recipe);
        wrong.replace("PE 30", QByteArray(65, '7'));
        QCOMPARE(store::fromJson(wrong, {}).error().kind, store::FileError::Kind::TooLong);
        wrong = store::toJson(recipe);
        wrong.replace("PE 30", "PE\\t30");
        QCOMPARE(store::fromJson(wrong, {}).error().key, u"film_code"_s);
    }
};

CAMPANEL_TEST(TestScan)

} // namespace campanel::panel::test_scan

#include "test_scan.moc"
