// SPDX-License-Identifier: Apache-2.0
// The ends of a cam: a closing error is closed in curve, figures and table alike, a larger difference is the
// exact advance of each cycle. Segments without motion are refused, and rounding is no jump.
#include "profile/cam/cam_table.h"
#include "profile/cam/point_cam_edit.h"
#include "profile/segments/segment_edit.h"
#include "random_cams.h"
#include "random_segments.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_cam_advance {

using namespace campanel::profile;

namespace {

constexpr SegmentMotion quintic = segmentMotion(LawId::Quintic);

CamSegment segment(double fromDeg, double toDeg, SegmentMotion motion, double endMm = 0)
{
    return {fromDeg, toDeg, motion, endMm, {}, {}, {}};
}

SegmentCamProgram camOf(std::vector<CamSegment> segments)
{
    SegmentCamProgram program;
    program.segments = std::move(segments);
    return program;
}

PointCamProgram knotsTo(double endMm, SplineEnds ends = SplineEnds::Periodic)
{
    PointCamProgram program; // a span of 50 mm
    program.knots.back().slaveMm = endMm;
    program.ends = ends;
    return program;
}

SegmentCamProgram segmentsTo(double endMm)
{
    return camOf({segment(0, 180, quintic, 50), segment(180, 360, quintic, endMm)});
}

// Returns what a cycle of the motion, of the figures and of the table moves the axis, in mm.
template <typename Cam> std::array<double, 3> cycleMm(const Cam& program)
{
    const Machine machine;
    const auto length = [](const MotionProfile& motion) {
        return motion.at(motion.durationS()).positionMm - motion.at(0).positionMm;
    };
    const auto solved = solve(program, machine);
    const auto table = buildCamTable(program, machine);
    if (!solved || !table)
        qFatal("%s", describe(solved ? table.error() : solved.error()).c_str());
    return {length(forwardMotion(program)), length(solved->motion),
            table->advance.asDouble() / axisPulsesPerMm(machine)};
}

template <typename Cam> void expectAdvance(const Cam& program, double expectedMm)
{
    for (const double mm : cycleMm(program))
        QVERIFY2(std::abs(mm - expectedMm) < 1e-9,
                 qPrintable(QStringLiteral("%1, not %2 mm per cycle").arg(mm).arg(expectedMm)));
}

} // namespace

class TestCamAdvance : public QObject {
    Q_OBJECT

private slots:
    void aClosingErrorIsClosed_data()
    {
        QTest::addColumn<double>("endMm");
        QTest::addColumn<double>("advanceMm");
        QTest::newRow("exact") << 0.0 << 0.0;
        QTest::newRow("0.8 %") << 0.4 << 0.0;
        QTest::newRow("1 %") << 0.5 << 0.0;
        QTest::newRow("1 % back") << -0.495 << 0.0;
        QTest::newRow("above 1 %") << 0.501 << 0.501;
        QTest::newRow("back") << -0.6 << -0.6;
        QTest::newRow("a feed") << 120.0 << 120.0;
    }
    void aClosingErrorIsClosed()
    {
        QFETCH(double, endMm);
        QFETCH(double, advanceMm);
        expectAdvance(segmentsTo(endMm), advanceMm);
        for (const SplineEnds ends : {SplineEnds::Periodic, SplineEnds::Natural, SplineEnds::Clamped})
            expectAdvance(knotsTo(endMm, ends), advanceMm);
        PointCamProgram scaled = knotsTo(endMm);
        scaled.slaveScale = -0.5;
        scaled.phaseDeg = 270;
        const auto [forward, solved, table] = cycleMm(scaled);
        QVERIFY(std::abs(forward + advanceMm / 2) < 1e-9 && std::abs(solved + advanceMm / 2) < 1e-9);
        QCOMPARE(table, -advanceMm / 2);
    }

    // The closed cam is one curve: no jump at any phase, and its last part takes up the error.
    void theClosedCurveIsContinuous()
    {
        QVERIFY(wrapCheck(knotsTo(0.4)).isSmooth);
        for (const SegmentJoint& joint : segmentJoints(segmentsTo(0.4)))
            QVERIFY(joint.isSmooth);
        SegmentCamProgram dwelling = camOf({segment(0, 150, quintic, 50), segment(150, 300, quintic, 0.4),
                                            segment(300, 330, SegmentMotion::Dwell),
                                            segment(330, 360, SegmentMotion::ConstantSpeed, 0.4)});
        expectAdvance(dwelling, 0);
        for (const SegmentJoint& joint : segmentJoints(dwelling)) // the dwells stand at 0, none moves back
            QVERIFY(joint.isSmooth);
        const MotionProfile motion = forwardMotion(dwelling);
        QVERIFY(std::abs(motion.at(motion.durationS() * 310 / 360).positionMm) < 1e-9);
    }

    // The largest positions that the registers hold: the sum of a closed cam's cycles stays exactly 0.
    void aFarClosedCamHasNoAdvance()
    {
        SegmentCamProgram far;
        far.segments.clear();
        for (int i = 0; i < 40; ++i)
            far.segments.push_back(segment(9 * i, 9 * (i + 1), quintic, i % 2 == 0 ? 1e6 : -1e6));
        far.segments.back().endMm = 12'345.678;
        far.slaveScale = 99.999;
        far.masterRateRevPerMin = 1;
        Machine machine;
        machine.feedMmPerMotorRev = 10000;
        machine.pulsesPerMotorRev = 1;
        const auto table = buildCamTable(far, machine);
        QVERIFY2(table, table ? "" : describe(table.error()).c_str());
        QCOMPARE(qint64{table->advance.whole}, 0);
        QCOMPARE(qint64{table->advance.remainder}, 0);
    }

    void polynomialsAtRestAreNoMotion()
    {
        const auto limitOf = [](const SegmentCamProgram& program) {
            const auto motion = solve(program, {});
            return motion ? std::string_view("a motion") : limitId(motion.error().limit);
        };
        SegmentCamProgram program = camOf(
            {segment(0, 180, SegmentMotion::Polynomial5), segment(180, 360, SegmentMotion::Polynomial3)});
        QCOMPARE(limitOf(program), std::string_view("no_motion"));
        program.segments[1].start.accelerationMmPerDeg2 = 0.1; // a polynomial 3 has none
        QCOMPARE(limitOf(program), std::string_view("no_motion"));
        program.segments[0].motion = SegmentMotion::ConstantSpeed;
        program.segments[0].start.speedMmPerDeg = 1;
        QCOMPARE(limitOf(program), std::string_view("no_motion"));
        program.segments[1].motion = SegmentMotion::Polynomial5; // now its acceleration counts
        QCOMPARE(limitOf(program), std::string_view("a motion"));
    }

    void roundingIsNoJump_data()
    {
        QTest::addColumn<int>("law");
        QTest::addColumn<double>("fromDeg");
        for (const LawId law : {LawId::Harmonic, LawId::Quintic, LawId::Cubic, LawId::ModifiedSine}) {
            for (const double fromDeg : {0.1, 33.3333, 180.0, 359.8})
                QTest::addRow("law %d at %g", static_cast<int>(law), fromDeg)
                    << static_cast<int>(law) << fromDeg;
        }
    }
    // 900 000 mm in 0.1 degrees: speeds of 10^7 mm/deg, accelerations of 10^9 mm/deg^2.
    void roundingIsNoJump()
    {
        QFETCH(int, law);
        QFETCH(double, fromDeg);
        SegmentCamProgram steep =
            camOf({segment(0, fromDeg, SegmentMotion::Dwell),
                   segment(fromDeg, fromDeg + 0.1, segmentMotion(static_cast<LawId>(law)), 900'000),
                   segment(fromDeg + 0.1, 360, segmentMotion(LawId::Harmonic), 0)});
        for (CamSegment& each : steep.segments)
            each.toDeg = std::round(each.toDeg * 1e4) / 1e4;
        for (const SegmentJoint& joint : segmentJoints(repaired(steep)))
            QVERIFY2(joint.isSmooth, qPrintable(QStringLiteral("%1 deg: %2 mm/deg, %3 mm/deg^2")
                                                    .arg(joint.masterDeg)
                                                    .arg(joint.speedMmPerDeg)
                                                    .arg(joint.accelerationMmPerDeg2)));
        // A true jump of two steps of the grid is one, also beside a usual curve.
        SegmentCamProgram jumping = repaired(segmentsTo(0));
        jumping.segments[0].motion = SegmentMotion::Polynomial5;
        jumping.segments[0].end.speedMmPerDeg = 2.1 * boundarySpeedStepMmPerDeg;
        QVERIFY(!segmentJoints(jumping)[1].isSmooth);
    }

    // Table, motion and figures of random cams agree on what a cycle moves.
    void randomCamsAgree()
    {
        constexpr unsigned seed = 4'131;
        qInfo("seed %u", seed);
        test::RandomCams cams(seed);
        test::RandomSegments segments(seed);
        int closed = 0;
        const auto check = [&closed](const auto& recipe) {
            const auto table = buildCamTable(recipe.program, recipe.machine);
            if (!solve(recipe.program, recipe.machine) || !table)
                return;
            const MotionProfile motion = forwardMotion(recipe.program);
            const double mm = motion.at(motion.durationS()).positionMm - motion.at(0).positionMm;
            closed += table->advance.whole == 0 && table->advance.remainder == 0;
            QVERIFY(std::abs(mm * axisPulsesPerMm(recipe.machine) - table->advance.asDouble()) < 1e-4);
        };
        for (int i = 0; i < 1000 && !QTest::currentTestFailed(); ++i) {
            check(cams.next());
            check(segments.next());
        }
        QVERIFY(closed > 100);
    }
};

CAMPANEL_TEST(TestCamAdvance)

} // namespace test_cam_advance

#include "test_cam_advance.moc"
