// SPDX-License-Identifier: Apache-2.0
// The approved windows of a recipe: which inputs can have one, and which values lie outside.
#include "app/program/recipe.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_approved_windows {

using namespace campanel::program;
using campanel::profile::Field;
using campanel::profile::ProgramKind;

class TestApprovedWindows : public QObject {
    Q_OBJECT

private slots:
    void aValueAtTheEndOfItsWindowIsInside()
    {
        Recipe recipe = defaultRecipe(ProgramKind::RotaryCutter); // 250 mm, 60 bags/min
        QVERIFY(outsideWindows(recipe).empty());
        recipe.windows[Field::Rate] = {55, 60};
        recipe.windows[Field::BagLength] = {250, 250};
        QVERIFY(outsideWindows(recipe).empty());
        setValue(recipe, Field::Rate, 60.04); // reads 60.0
        QVERIFY(outsideWindows(recipe).empty());
        setValue(recipe, Field::Rate, 60.1);
        const auto outside = outsideWindows(recipe);
        QCOMPARE(outside.size(), 1U);
        QCOMPARE(outside.front().field, Field::Rate);
        QCOMPARE(outside.front().value, 60.1);
        QVERIFY(outside.front().window == (ApprovedWindow{55, 60}));
    }

    // v_a and v_b follow from length and rate, whatever the recipe has stored for them; so they do in the
    // recipe that is sent, which has 0 there.
    void aValueThatFollowsCountsToo()
    {
        Recipe recipe = defaultRecipe(ProgramKind::RotaryCutter);
        recipe.windows[Field::FilmSpeed] = {240, 260}; // 250 mm a second
        for (const Recipe& each : {recipe, quantised(recipe)})
            QVERIFY(outsideWindows(each).empty());
        setValue(recipe, Field::Rate, 72);
        for (const Recipe& each : {recipe, quantised(recipe)}) {
            const auto outside = outsideWindows(each);
            QCOMPARE(outside.size(), 1U);
            QCOMPARE(outside.front().value, 300.0);
        }
    }

    void eachKindHasMeasuresThatCanHaveAWindow()
    {
        for (const KindInfo& kind : kinds()) {
            Recipe recipe = defaultRecipe(kind.kind);
            int measures = 0;
            for (const Field field : kind.programFields) {
                if (!canHaveWindow(recipe, field))
                    continue;
                ++measures;
                recipe.windows[field] = {campanel::profile::info(field).max,
                                         campanel::profile::info(field).max};
            }
            QVERIFY(measures > 0);
            QVERIFY(!outsideWindows(recipe).empty());
            QVERIFY(!canHaveWindow(recipe, Field::SlicesPerRamp));
            for (const Field field : kind.machineFields)
                QVERIFY(!canHaveWindow(recipe, field));
        }
    }
};

CAMPANEL_TEST(TestApprovedWindows)

} // namespace test_approved_windows

#include "test_approved_windows.moc"
