// SPDX-License-Identifier: Apache-2.0
// The operator's hand on cut, product and length: steps and limits, where a row is off and why, the audit
// trail, and what is saved with the recipe.
#include "app/panel/hand/hand_trims.h"
#include "app/panel/library/recipes.h"
#include "tests/app/panel/hand/hand_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>

namespace test_hand_trims {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using panel::HandTrims;
using panel::TrimRow;

namespace {

enum Row { Cut, Product, Length };

struct TrimRig : HandRig {
    HandTrims hand{machine, nullptr};

    TrimRig() { registers["parameter.mark_tracking"] = 1; }
    // Connects and reads what the hand needs.
    void run()
    {
        connectRunning();
        machine.parameter("parameter.mark_tracking").readIfUncertain();
        machine.parameter("master.place").readIfUncertain();
        answer();
    }
    [[nodiscard]] const TrimRow& row(Row row) { return hand.rows()->row(row); }
};

} // namespace

class TestHandTrims : public QObject {
    Q_OBJECT

private slots:
    void stepsFollowTheFilmOnTheScreen()
    {
        TrimRig rig;
        rig.run();
        QVERIFY(rig.hand.offered());
        QCOMPARE(rig.hand.rows()->count(), 3);
        QCOMPARE(rig.row(Cut).amount, u"0.0 mm"_s);
        QVERIFY(!rig.hand.moved() && !rig.row(Cut).canReset);
        QCOMPARE(rig.row(Cut).rightText, u"Earlier"_s); // the film runs to the right
        QCOMPARE(rig.row(Product).rightText, u"Forward"_s);
        for (int touch = 0; touch < 4; ++touch) {
            rig.hand.right(Cut);
            rig.answer();
        }
        rig.hand.right(Product);
        rig.answer();
        QCOMPARE(rig.registers["hand.cut"], -2.0);
        QCOMPARE(rig.registers["hand.product"], 0.5);
        QCOMPARE(rig.row(Cut).amount, u"2.0 mm earlier"_s);
        QCOMPARE(rig.row(Product).amount, u"0.5 mm forward"_s);
        QVERIFY(rig.hand.moved());
        rig.hand.left(Cut);
        rig.answer();
        QCOMPARE(rig.registers["hand.cut"], -1.5);
        rig.hand.reset(Cut);
        rig.hand.reset(Product);
        rig.answer();
        QVERIFY(!rig.hand.moved());
    }

    void touchesOnASlowLineAreOneWrite()
    {
        TrimRig rig;
        rig.run();
        for (int touch = 0; touch < 30; ++touch)
            rig.hand.left(Cut);
        QCOMPARE(rig.written("hand.cut"), QList<double>{0.5}); // the first is on its way
        QCOMPARE(rig.row(Cut).amount, u"10.0 mm later"_s);
        QVERIFY(!rig.row(Cut).canLeft && rig.row(Cut).canRight);
        QCOMPARE(rig.row(Cut).note, u"Limit reached: ±10 mm."_s);
        rig.answer();
        QCOMPARE(rig.written("hand.cut"), (QList<double>{0.5, 10.0}));
    }

    void theStepIsASetting()
    {
        TrimRig rig;
        rig.run();
        rig.settings.set("hand.trim_step_mm", u"0.2"_s);
        QCOMPARE(rig.hand.stepText(), u"0.2 mm"_s);
        rig.hand.right(Product);
        rig.answer();
        QCOMPARE(rig.registers["hand.product"], 0.2);
    }

    void rowsThatCannotActSayWhy()
    {
        TrimRig rig;
        rig.run();
        QVERIFY(!rig.row(Length).canLeft && !rig.row(Length).canRight);
        QCOMPARE(rig.row(Length).note, u"The marks set the length."_s);
        rig.hand.right(Length);
        QVERIFY(rig.written("hand.length").isEmpty());
        rig.machine.parameter("parameter.mark_tracking").write(0, {});
        rig.answer();
        QVERIFY(rig.row(Length).canRight && rig.row(Length).note.isEmpty());
        rig.hand.right(Length);
        rig.answer();
        QCOMPARE(rig.registers["hand.length"], 0.5);

        QVERIFY(rig.row(Product).canRight);
        rig.machine.parameter("master.source").write(1, {});
        rig.answer();
        QVERIFY(rig.row(Product).canRight); // of a shaft
        rig.machine.parameter("master.place").write(1, {});
        rig.answer();
        QVERIFY(!rig.row(Product).canRight);
        QCOMPARE(rig.row(Product).note, u"The line before this machine places the products."_s);
        QVERIFY(rig.row(Cut).canRight);
    }

    void anOlderControllerHasNone()
    {
        TrimRig rig;
        rig.mapMinor = 5;
        rig.run();
        QVERIFY(!rig.hand.offered());
        QCOMPARE(rig.hand.rows()->count(), 0);
        rig.hand.right(Cut);
        QVERIFY(rig.written("hand.cut").isEmpty());
    }

    void isForOperators()
    {
        TrimRig rig;
        rig.run();
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        QSignalSpy refused(&rig.machine.accessCheck(), &panel::AccessCheck::refused);
        QSignalSpy saved(&rig.hand, &HandTrims::saveWanted);
        rig.hand.right(Cut);
        rig.hand.save();
        QCOMPARE(refused.size(), 2);
        QVERIFY(rig.written("hand.cut").isEmpty() && saved.isEmpty());
    }

    void aWriteThatFailsIsTold()
    {
        TrimRig rig;
        rig.run();
        rig.hand.right(Product);
        rig.answer(link::ParameterEnd::OutcomeUnknown);
        rig.answer();
        QVERIFY(rig.hand.message().contains(u"Product"_s));
        QCOMPARE(rig.row(Product).amount, u"0.0 mm"_s); // as read
    }

    void aRowOfTouchesIsOneRowOfTheTrail()
    {
        TrimRig rig;
        rig.run();
        QSignalSpy noted(&rig.hand, &HandTrims::noted);
        for (int touch = 0; touch < 4; ++touch) {
            rig.hand.right(Cut);
            rig.answer();
        }
        QTRY_COMPARE_WITH_TIMEOUT(noted.size(), 1, 10'000);
        const auto entry = noted.first().first().value<store::AuditEntry>();
        QCOMPARE(entry.what, u"hand.trim"_s);
        QCOMPARE(entry.object, u"hand.cut"_s);
        QCOMPARE(entry.before, u"0"_s);
        QCOMPARE(entry.after, u"-2"_s);
    }

    // The recipe that runs gets them as its next version, in the library and in the editor; its next download
    // writes them before the program.
    void savedTrimsComeWithTheRecipe()
    {
        TrimRig rig;
        panel::Recipes recipes{rig.machine, rig.editor, rig.records, rig.folder.path(), nullptr};
        QObject::connect(&rig.hand, &HandTrims::saveWanted, &recipes, &panel::Recipes::saveTrims);
        rig.hand.setSaved([&recipes](const QString& recipe) {
            const store::RecipeVersion* found = recipes.named(recipe);
            return found ? std::optional(found->recipe.trims) : std::nullopt;
        });
        rig.run();
        QVERIFY(!rig.hand.unsaved()); // none are needed
        const QString name = rig.editor.recipeName();
        rig.hand.right(Cut);
        rig.answer();
        rig.hand.save();
        QVERIFY(recipes.message().contains(name)); // it is not among the recipes yet
        recipes.save();
        QTRY_VERIFY(recipes.named(name) != nullptr);
        QVERIFY(rig.hand.unsaved());
        rig.hand.save();
        QTRY_COMPARE(recipes.named(name)->recipe.trims, (program::Trims{-0.5, 0.0, 0.0}));
        const store::RecipeVersion* kept = recipes.named(name);
        QVERIFY(rig.hand.moved() && !rig.hand.unsaved());
        rig.hand.right(Cut);
        rig.answer();
        QVERIFY(rig.hand.unsaved());
        rig.hand.left(Cut);
        rig.answer();
        QVERIFY(!rig.hand.unsaved());
        QCOMPARE(rig.editor.recipe().trims, kept->recipe.trims);
        QCOMPARE(rig.editor.storedRecipe().trims, kept->recipe.trims);
        rig.editor.programDownload()->download(rig.image(), rig.editor.recipe());
        QCOMPARE(rig.written("hand.next_cut"), QList<double>{-0.5});
        QCOMPARE(rig.written("hand.next_product"), QList<double>{0.0});
        QCOMPARE(rig.written("hand.next_length"), QList<double>{0.0});
    }
};

CAMPANEL_TEST(TestHandTrims)

} // namespace test_hand_trims

#include "test_hand_trims.moc"
