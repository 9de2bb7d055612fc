// SPDX-License-Identifier: Apache-2.0
// The net advance of a recipe's axis: its sign and size, the same in the bank, and its confirmation.
#include "app/program/cam_advance.h"
#include "app/program/program_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_cam_advance {

using namespace campanel;
using namespace campanel::program;
using profile::PointCamProgram;
using profile::ProgramKind;
using profile::SegmentCamProgram;

namespace {

PointCamProgram knotsTo(double endMm)
{
    PointCamProgram cam;
    cam.knots.back().slaveMm = endMm;
    return cam;
}

SegmentCamProgram segmentsTo(double endMm)
{
    SegmentCamProgram cam;
    cam.segments[2].endMm = endMm; // a dwell follows
    return cam;
}

} // namespace

class TestCamAdvance : public QObject {
    Q_OBJECT

private slots:
    void theAxisAdvancesByTheTable_data()
    {
        QTest::addColumn<double>("endMm");
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("advanceMm");
        QTest::newRow("closed") << 0.0 << 1.0 << 60.0 << 0.0;
        QTest::newRow("closing error") << 0.4 << 2.0 << -60.0 << 0.0;
        QTest::newRow("forward") << 0.6 << 1.0 << 60.0 << 0.6;
        QTest::newRow("scaled") << 0.6 << -1.234 << 60.0 << -0.7404;
        QTest::newRow("reverse") << 12.5 << 0.5 << -30.0 << -6.25;
        QTest::newRow("off the grid") << 0.60049 << 1.00049 << 60.0 << 0.6;
    }
    void theAxisAdvancesByTheTable()
    {
        QFETCH(double, endMm);
        QFETCH(double, scale);
        QFETCH(double, rate);
        QFETCH(double, advanceMm);
        for (profile::Program cam : {profile::Program(knotsTo(endMm)), profile::Program(segmentsTo(endMm))}) {
            setValue(cam, profile::Field::SlaveScale, scale);
            setValue(cam, profile::Field::MasterRate, rate);
            QCOMPARE(program::advanceMm(cam), advanceMm);
            Recipe recipe = defaultRecipe(profile::kindOf(cam));
            recipe.program = cam;
            const auto image = buildProgram(recipe);
            QVERIFY2(image, image ? "" : describe(image.error()).c_str());
            const double inBank = program::advanceMm(image->registers, image->recipe);
            QVERIFY2(std::abs(inBank - advanceMm) < 1e-9, qPrintable(QString::number(inBank, 'g', 12)));
        }
    }

    void anAdvanceIsConfirmedForItsValue()
    {
        profile::Program cam = knotsTo(0.6);
        QVERIFY(!isAdvanceConfirmed(cam));
        confirmAdvance(cam);
        QVERIFY(isAdvanceConfirmed(cam));
        QCOMPARE(confirmedAdvanceMm(cam), 0.6);
        setConfirmedAdvance(cam, 0.6 * (1 + 1e-12)); // rounding
        QVERIFY(isAdvanceConfirmed(cam));
        for (const auto& [field, value] :
             {std::pair{profile::Field::SlaveScale, 1.002}, std::pair{profile::Field::MasterRate, -60.0}}) {
            profile::Program changed = cam;
            setValue(changed, field, value);
            QVERIFY(!isAdvanceConfirmed(changed));
        }
        setValue(cam, profile::Field::MasterRate, 30.0); // slower, but as far in a cycle
        QVERIFY(isAdvanceConfirmed(cam));
        std::get<PointCamProgram>(cam).knots.back().slaveMm = 0.601;
        QVERIFY(!isAdvanceConfirmed(cam));
        std::get<PointCamProgram>(cam).knots.back().slaveMm = 0.4; // closed: nothing to confirm
        QVERIFY(isAdvanceConfirmed(cam));
        for (const KindInfo& kind : kinds()) {
            profile::Program other = kind.defaultProgram();
            QVERIFY(isAdvanceConfirmed(other));
            setConfirmedAdvance(other, 5);
            QCOMPARE(confirmedAdvanceMm(other), profile::camMaster(other) ? 5.0 : 0.0);
        }
    }

    void aClosedCamEndsWhereItBegan()
    {
        profile::Program knots = knotsTo(376.991);
        closeCam(knots);
        QCOMPARE(program::advanceMm(knots), 0.0);
        QCOMPARE(std::get<PointCamProgram>(knots).knots.back().slaveMm, 0.0);
        profile::Program segments = segmentsTo(-30);
        QCOMPARE(program::advanceMm(segments), -30.0);
        closeCam(segments);
        QCOMPARE(program::advanceMm(segments), 0.0);
        QCOMPARE(std::get<SegmentCamProgram>(segments).segments[2].endMm, 0.0);
        QCOMPARE(std::get<SegmentCamProgram>(segments).segments[1].endMm, 50.0);
        QCOMPARE(closingErrorMm(knotsTo(-0.5)), -0.5);
        QCOMPARE(closingErrorMm(segmentsTo(0.5)), 0.5);
        QCOMPARE(closingErrorMm(segmentsTo(0.6)), 0.0);
    }

    void anInvalidListAdvancesNothing()
    {
        PointCamProgram cam;
        cam.knots.clear();
        QCOMPARE(program::advanceMm(cam), 0.0);
        closeCam(*std::make_unique<profile::Program>(cam));
        SegmentCamProgram gap = segmentsTo(30);
        gap.segments[1].fromDeg = 130;
        QCOMPARE(program::advanceMm(gap), 0.0);
        gap.segments.clear();
        QCOMPARE(closingErrorMm(gap), 0.0);
    }
};

CAMPANEL_TEST(TestCamAdvance)

} // namespace test_cam_advance

#include "test_cam_advance.moc"
