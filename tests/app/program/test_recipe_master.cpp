// SPDX-License-Identifier: Apache-2.0
// Which recipe runs on which machine, by the master of both.
#include "app/program/recipe_master.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_recipe_master {

using namespace campanel::program;
using campanel::profile::ProgramKind;

class TestRecipeMaster : public QObject {
    Q_OBJECT

private slots:
    void theMachineHasTheMasterOfTheRecipe()
    {
        using enum RecipeMaster;
        using Is = MasterRefusal;
        struct Row {
            RecipeMaster master;
            MachineMaster machine; // follows an encoder, has an input
            MasterRefusal refusal;
        };
        for (const Row& row :
             {Row{Any, {false, false}, Is::None}, Row{Any, {false, true}, Is::None},
              Row{Any, {true, true}, Is::None}, Row{Any, {true, false}, Is::NoInput},
              Row{Clock, {false, false}, Is::None}, Row{Clock, {false, true}, Is::None},
              Row{Clock, {true, true}, Is::NeedsClock}, Row{Clock, {true, false}, Is::NeedsClock},
              Row{Encoder, {false, false}, Is::NeedsInput}, Row{Encoder, {true, false}, Is::NeedsInput},
              Row{Encoder, {false, true}, Is::NeedsEncoder}, Row{Encoder, {true, true}, Is::None}}) {
            for (const auto kind :
                 {ProgramKind::RotaryCutter, ProgramKind::PointCam, ProgramKind::SegmentCam}) {
                Recipe recipe = defaultRecipe(kind);
                recipe.master = row.master;
                QCOMPARE(masterRefusal(recipe, row.machine), row.refusal);
            }
            for (const auto kind : {ProgramKind::PositionMove, ProgramKind::SpeedMove, ProgramKind::Press}) {
                Recipe recipe = defaultRecipe(kind);
                recipe.master = row.master;
                QVERIFY(!hasMaster(recipe));
                QCOMPARE(masterRefusal(recipe, row.machine), Is::None);
            }
        }
    }

    void anEncoderDoesNotTurnInReverse()
    {
        Recipe recipe = defaultRecipe(ProgramKind::PointCam);
        setValue(recipe, campanel::profile::Field::MasterRate, -60);
        QCOMPARE(masterRefusal(recipe, {false, true}), MasterRefusal::None);
        QCOMPARE(masterRefusal(recipe, {true, true}), MasterRefusal::CannotFollow);
    }

    void theKeysAreThoseOfTheFile()
    {
        QCOMPARE(masterByKey("any"), RecipeMaster::Any);
        QCOMPARE(masterByKey("clock"), RecipeMaster::Clock);
        QCOMPARE(masterByKey("encoder"), RecipeMaster::Encoder);
        QVERIFY(!masterByKey("Encoder"));
        QVERIFY(!masterByKey(""));
    }
};

CAMPANEL_TEST(TestRecipeMaster)

} // namespace test_recipe_master

#include "test_recipe_master.moc"
