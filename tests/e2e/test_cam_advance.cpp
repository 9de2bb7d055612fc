// SPDX-License-Identifier: Apache-2.0
// The ends of a cam from the recipe to the axis: one that its table closes keeps its place, a progressive one
// moves on by exactly the stated advance.
#include "app/program/cam_advance.h"
#include "app/program/program_image.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

namespace test_cam_advance {

using namespace campanel;
using profile::ProgramKind;
using test::Rig;

namespace {

constexpr std::uint64_t second = 1'000'000; // us

// Returns a small cam with ten cycles in a second, whose ends differ by a share of its span of 5 mm.
program::Recipe recipeOf(ProgramKind kind, double share, double rate)
{
    program::Recipe recipe = program::defaultRecipe(kind);
    if (auto* knots = std::get_if<profile::PointCamProgram>(&recipe.program))
        knots->knots.back().slaveMm = 50 * share;
    if (auto* segments = std::get_if<profile::SegmentCamProgram>(&recipe.program))
        segments->segments[2].endMm = 50 * share;
    program::setValue(recipe.program, profile::Field::SlaveScale, 0.1);
    program::setValue(recipe.program, profile::Field::MasterRate, rate);
    program::setValue(recipe.program, profile::Field::MasterRamp, 0.2);
    return recipe;
}

} // namespace

class TestCamAdvance : public QObject {
    Q_OBJECT

private slots:
    void theAxisEndsWhereTheRecipeSays_data()
    {
        QTest::addColumn<ProgramKind>("kind");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("advanceMm");
        for (const auto& [name, kind] :
             {std::pair{"knots", ProgramKind::PointCam}, {"segments", ProgramKind::SegmentCam}}) {
            QTest::addRow("%s, 0.8 %% apart", name) << kind << 0.008 << 600.0 << 0.0;
            QTest::addRow("%s, 1 %% apart, reverse", name) << kind << -0.01 << -600.0 << 0.0;
            QTest::addRow("%s, progressive", name) << kind << 0.01202 << 600.0 << 0.0601;
            QTest::addRow("%s, progressive in reverse", name) << kind << 0.5 << -600.0 << -2.5;
        }
    }
    void theAxisEndsWhereTheRecipeSays()
    {
        QFETCH(ProgramKind, kind);
        QFETCH(double, share);
        QFETCH(double, rate);
        QFETCH(double, advanceMm);
        const program::Recipe recipe = recipeOf(kind, share, rate);
        QCOMPARE(program::advanceMm(recipe.program), advanceMm);
        const auto image = program::buildProgram(recipe);
        QVERIFY2(image, image ? "" : program::describe(image.error()).c_str());
        constexpr unsigned seed = 5;
        qInfo("seed %u", seed);
        std::mt19937_64 random(seed);
        Rig rig;
        QCOMPARE(rig.download(image->registers), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image->registers, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
        const double pulsesPerCycle = advanceMm * image->solved.pulsesPerMm;
        // A few cycles, then more, and more than a thousand in all.
        for (const std::uint64_t runUs :
             {second / 20, second, 5 * second + random() % second, 105 * second}) {
            rig.start();
            rig.run(runUs);
            QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
            QVERIFY(rig.runUntilState(CTL_STATE_READY));
            rig.run(2 * second); // the axis follows with a lag
            const double exact = rig.core().motion.cycle_count * pulsesPerCycle;
            const std::int64_t commanded = rig.commanded();
            QVERIFY2(std::abs(static_cast<double>(commanded) - exact) <= (advanceMm == 0 ? 0 : 1),
                     qPrintable(QStringLiteral("%1 cycles: %2 pulses, not %3")
                                    .arg(rig.core().motion.cycle_count)
                                    .arg(commanded)
                                    .arg(exact)));
            QCOMPARE(rig.core().motion.actual - rig.core().motion.origin, commanded);
        }
        QVERIFY(rig.core().motion.cycle_count > 1000);
    }
};

CAMPANEL_TEST(TestCamAdvance)

} // namespace test_cam_advance

#include "test_cam_advance.moc"
