// SPDX-License-Identifier: Apache-2.0
// Point cams: invalid knots, the cycle in time (scales, phase, direction, wrap), limits and the rate that
// corrects them, the wrap check and its repair, and the panel's edits.
#include "move_checks.h"

#include "profile/cam/point_cam_edit.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

namespace test_point_cam {

using namespace campanel::profile;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

bool near(double actual, double expected, double tolerance = 1e-9)
{
    return std::abs(actual - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

PointCamProgram knifeCam()
{
    PointCamProgram program;
    program.knots = {{0, 0}, {60, 80}, {150, 140}, {200, 230}, {290, 300}, {360, 376.991}};
    program.masterRateRevPerMin = 30;
    return program;
}

MotionPoint endOf(const MotionProfile& motion)
{
    const Segment& last = motion.segments().back();
    return last.at(last.endS());
}

AxisMotion solved(const PointCamProgram& program, const Machine& machine = {})
{
    const auto motion = solve(program, machine);
    if (!motion)
        qFatal("%s", describe(motion.error()).c_str());
    return *motion;
}

const Refusal* find(const AxisMotion& motion, Limit limit)
{
    for (const Refusal& refusal : motion.broken) {
        if (refusal.limit == limit)
            return &refusal;
    }
    return nullptr;
}

} // namespace

class TestPointCam : public QObject {
    Q_OBJECT

private slots:
    void refusesBadKnots_data();
    void refusesBadKnots();
    void refusesOtherBadInputs();
    void cycleFollowsTheSpline_data();
    void cycleFollowsTheSpline();
    void limitsNameTheRateThatMends();
    void overshootIsNamed();
    void wrapJumpIsNamedAndRepaired();
    void wrapJumpTakesTorque();
    void nearlyClosedIsClosedByRepair();
    void insertsOnTheCurve();
    void removesAndMoves();
};

void TestPointCam::refusesBadKnots_data()
{
    QTest::addColumn<QList<QPointF>>("knots");
    QTest::addColumn<QByteArray>("limit");
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("allowed");
    using Knots = QList<QPointF>;
    const auto row = [](const char* name, const Knots& knots, const char* limit, int index, double allowed) {
        QTest::newRow(name) << knots << QByteArray(limit) << index << allowed;
    };
    row("none", {}, "knot_count", 0, 5);
    row("four", {{0, 0}, {90, 1}, {180, 2}, {360, 0}}, "knot_count", 0, 5);
    Knots many;
    for (int i = 0; i <= 100; ++i)
        many.append({3.6 * i, 1.0 * (i % 2)});
    row("a hundred and one", many, "knot_count", 0, 100);
    row("not ascending", {{0, 0}, {180, 1}, {90, 2}, {270, 1}, {360, 0}}, "knot_order", 2, 180);
    row("duplicate", {{0, 0}, {90, 1}, {90, 2}, {270, 1}, {360, 0}}, "knot_order", 2, 90);
    row("too close", {{0, 0}, {90, 1}, {90.0999, 2}, {270, 1}, {360, 0}}, "knot_spacing", 2, 0.1);
    row("beyond the period", {{0, 0}, {90, 1}, {180, 2}, {270, 1}, {360.5, 0}}, "knot_range", 4, 360);
    row("before the period", {{-1, 0}, {90, 1}, {180, 2}, {270, 1}, {360, 0}}, "knot_range", 0, 0);
    row("no angle", {{0, 0}, {noNumber, 1}, {180, 2}, {270, 1}, {360, 0}}, "knot_range", 1, 0);
    row("slave too far", {{0, 0}, {90, 1}, {180, -2e6}, {270, 1}, {360, 0}}, "knot_range", 2, -1e6);
    row("no slave", {{0, 0}, {90, 1}, {180, noNumber}, {270, 1}, {360, 0}}, "knot_range", 2, 0);
    row("late first", {{1, 0}, {90, 1}, {180, 2}, {270, 1}, {360, 0}}, "knot_ends", 0, 0);
    row("early last", {{0, 0}, {90, 1}, {180, 2}, {270, 1}, {359, 0}}, "knot_ends", 4, 360);
}

void TestPointCam::refusesBadKnots()
{
    QFETCH(QList<QPointF>, knots);
    QFETCH(QByteArray, limit);
    QFETCH(int, index);
    QFETCH(double, allowed);
    PointCamProgram program;
    program.knots.clear();
    for (const QPointF& knot : knots)
        program.knots.push_back({knot.x(), knot.y()});
    const auto motion = solve(program, {});
    QVERIFY(!motion.has_value());
    QCOMPARE(QByteArray::fromStdString(std::string(limitId(motion.error().limit))), limit);
    QCOMPARE(motion.error().index, index);
    QCOMPARE(motion.error().allowed, allowed);
}

void TestPointCam::refusesOtherBadInputs()
{
    PointCamProgram program;
    program.masterRateRevPerMin = 0;
    QVERIFY(solve(program, {}).error().limit == Limit::NoMotion);
    QVERIFY(solve(program, {}).error().field == Field::MasterRate);
    program = {};
    program.slaveScale = 0;
    QVERIFY(solve(program, {}).error().field == Field::SlaveScale);
    program = {};
    for (Knot& knot : program.knots)
        knot.slaveMm = 7;
    QVERIFY(solve(program, {}).error().limit == Limit::NoMotion);
    for (const Field field : {Field::MasterRate, Field::MasterRamp, Field::MasterRatio, Field::MasterScale,
                              Field::SlaveScale, Field::Phase, Field::CamPoints}) {
        program = {};
        setValue(program, field, info(field).max + 1);
        QCOMPARE(value(program, field), info(field).max + 1);
        const auto refused = solve(program, {});
        QVERIFY(!refused.has_value());
        QVERIFY(refused.error().limit == Limit::FieldRange && refused.error().field == field);
        for (const Suggestion& s : refused.error().nearest) {
            setValue(program, s.field, s.value);
            QVERIFY(solved(program).broken.empty());
        }
    }
    program.phaseDeg = noNumber;
    QVERIFY(solve(program, {}).error().field == Field::Phase);
    Machine machine;
    machine.feedMmPerMotorRev = 0;
    QVERIFY(solve(PointCamProgram{}, machine).error().field == Field::FeedPerMotorRev);
}

void TestPointCam::cycleFollowsTheSpline_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("phase");
    QTest::addColumn<int>("ends");
    for (const double rate : {30.0, -30.0, 12.5}) {
        for (const double phase : {0.0, 60.0, 100.0, -0.1, -360.0, 359.9}) {
            for (int ends = 0; ends < 3; ++ends)
                QTest::addRow("%g r/min from %g deg, ends %d", rate, phase, ends) << rate << phase << ends;
        }
    }
}

void TestPointCam::cycleFollowsTheSpline()
{
    QFETCH(double, rate);
    QFETCH(double, phase);
    QFETCH(int, ends);
    PointCamProgram program = knifeCam();
    program.masterRateRevPerMin = rate;
    program.phaseDeg = phase;
    program.ends = static_cast<SplineEnds>(ends);
    program.masterRatio = 10;
    program.masterScale = 0.5;
    program.slaveScale = -1.5;
    const AxisMotion cam = solved(program);
    const double cycleS = 60 / std::abs(rate) * 10 * 0.5;
    QVERIFY(near(cam.motion.durationS(), cycleS, 1e-12));
    QCOMPARE(camCycleS(program), cycleS);
    const Spline curve = camCurve(program);
    const double degPerS = (rate > 0 ? 360 : -360) / cycleS;
    for (int i = 0; i < 200; ++i) {
        const double timeS = cycleS * (i + 0.5) / 200;
        const double total = phase + degPerS * timeS;
        const double turns = std::floor(total / 360);
        const SplinePoint expected = curve.at(total - 360 * turns);
        const MotionPoint p = cam.motion.at(timeS);
        // A negative phase starts in the present cycle, not in the previous one.
        const double startTurn = std::floor(phase / 360);
        QVERIFY(near(p.positionMm, -1.5 * (expected.value + 376.991 * (turns - startTurn))));
        QVERIFY(near(p.velocityMmPerS, -1.5 * expected.slope * degPerS));
        QVERIFY(near(p.accelerationMmPerS2, -1.5 * expected.curvature * degPerS * degPerS));
        QVERIFY(near(p.jerkMmPerS3, -1.5 * expected.third * degPerS * degPerS * degPerS));
    }
    const double netMm = endOf(cam.motion).positionMm - cam.motion.at(0).positionMm;
    QVERIFY(near(netMm, (rate > 0 ? -1.5 : 1.5) * 376.991, 1e-12));
    const MotionProfile forward = forwardMotion(program);
    QVERIFY(near(forward.at(cycleS / 3).positionMm - forward.at(0).positionMm,
                 -1.5 * (curve.at(std::fmod(phase + 360 + 120, 360)).value +
                         376.991 * (std::floor((phase + 120) / 360) - std::floor(phase / 360)) -
                         curve.at(std::fmod(phase + 360, 360)).value)));
    QVERIFY(cam.marksS.size() >= 6);
    for (const double mark : cam.marksS)
        QVERIFY(mark >= 0 && mark <= cycleS * (1 + 1e-12));
}

void TestPointCam::limitsNameTheRateThatMends()
{
    // Default knots, 60 r/min: the curve's peak acceleration is at 180 degrees.
    PointCamProgram program;
    const AxisMotion calm = solved(program);
    QVERIFY(calm.broken.empty());
    QVERIFY(near(calm.peaks.accelerationTimeS, 0.5));
    Machine machine;
    machine.maxAccelerationMmPerS2 = std::floor(calm.peaks.accelerationMmPerS2 / 4);
    for (const double rate : {60.0, -60.0}) {
        program.masterRateRevPerMin = rate;
        const AxisMotion broken = solved(program, machine);
        QCOMPARE(broken.broken.size(), std::size_t{1});
        const Refusal& refusal = broken.broken.front();
        QVERIFY(refusal.limit == Limit::AxisAcceleration);
        QVERIFY(near(refusal.angleDeg.value_or(-1), 180, 1e-6));
        QCOMPARE(refusal.nearest.size(), std::size_t{1});
        QVERIFY(std::abs(std::abs(refusal.nearest.front().value) - 30) < 0.5);
        program.masterRateRevPerMin = refusal.nearest.front().value;
        QVERIFY(program.masterRateRevPerMin * rate > 0);
        QVERIFY(solved(program, machine).broken.empty());
        program.masterRateRevPerMin += std::copysign(0.1, rate); // the next one on the grid is too fast
        QVERIFY(!solved(program, machine).broken.empty());
    }
}

void TestPointCam::overshootIsNamed()
{
    // A steep rise between two dwells: the spline overshoots on both sides.
    PointCamProgram program;
    program.knots = {{0, 0}, {150, 0}, {170, 100}, {270, 100}, {360, 0}};
    for (const SplineEnds ends : {SplineEnds::Natural, SplineEnds::Clamped, SplineEnds::Periodic}) {
        program.ends = ends;
        const AxisMotion motion = solved(program);
        const Refusal* overshoot = find(motion, Limit::Overshoot);
        QVERIFY(overshoot != nullptr);
        QVERIFY(overshoot->nearest.empty());
        QVERIFY(overshoot->actual < -10 || overshoot->actual > 110);
        QCOMPARE(overshoot->allowed, overshoot->actual < 0 ? 0.0 : 100.0);
        // No point on a dense grid is farther.
        const Spline curve = camCurve(program);
        double farthest = 0;
        for (int i = 0; i <= 36000; ++i) {
            const double s = curve.at(i / 100.0).value;
            farthest = std::max({farthest, s - 100, -s});
        }
        QVERIFY(near(std::max(overshoot->actual - 100, -overshoot->actual), farthest, 1e-4));
        QVERIFY(near(motion.motion.at(overshoot->timeS.value_or(-1)).positionMm, overshoot->actual));
    }
    QVERIFY(find(solved(PointCamProgram{}), Limit::Overshoot) == nullptr);
}

// The default cam at 58 r/min: 99.4 mm/s in 2 ms are 49 714 mm/s^2, with 5 kg cm^2 on 100 mm 1.5618 Nm and
// 0.02 Nm of friction.
void TestPointCam::wrapJumpTakesTorque()
{
    PointCamProgram program;
    program.ends = SplineEnds::Natural;
    program.masterRateRevPerMin = 58;
    Machine machine = test::paperMotor();
    machine.maxMotorRpm = 7200;
    machine.inertiaKgCm2 = 5;
    const AxisMotion motion = solved(program, machine);
    QVERIFY(std::abs(motion.peaks.torqueNm - 1.5818) < 1e-4);
    QVERIFY(std::abs(motion.peaks.accelerationMmPerS2 - 49714.3) < 0.1);
    QVERIFY(std::isinf(motion.peaks.jerkMmPerS3));
    QCOMPARE(motion.broken.size(), std::size_t{1});
    const Refusal* jump = find(motion, Limit::WrapJump);
    QVERIFY(jump != nullptr);
    QVERIFY(std::abs(jump->allowed - 0.002 * 1.31 / (5e-4 * 2 * std::acos(-1.0) / 100)) < 1e-6);
    QCOMPARE(jump->nearest.size(), std::size_t{1});
    program.masterRateRevPerMin = jump->nearest[0].value;
    const AxisMotion slower = solved(program, machine);
    QVERIFY(slower.broken.empty());
    QVERIFY(slower.peaks.torqueNm <= machine.maxTorqueNm);
    program.masterRateRevPerMin += 0.1;
    QVERIFY(!solved(program, machine).broken.empty());
    program.ends = SplineEnds::Periodic; // no jump
    QVERIFY(std::isfinite(solved(program, machine).peaks.jerkMmPerS3));
    QVERIFY(solved(program, machine).peaks.torqueNm < 0.1);
}

void TestPointCam::wrapJumpIsNamedAndRepaired()
{
    PointCamProgram program;
    program.knots = {{0, 0}, {90, 200}, {180, 350}, {270, 200}, {360, 0}};
    program.ends = SplineEnds::Natural;
    program.masterRateRevPerMin = 60;
    const WrapCheck wrap = wrapCheck(program);
    // By symmetry the slope at the end is the negative of that at the start.
    QVERIFY(!wrap.isSmooth);
    QVERIFY(near(wrap.speedMmPerDeg, 2 * camCurve(program).at(0).slope));
    QVERIFY(std::abs(wrap.accelerationMmPerDeg2) < 1e-12);
    QCOMPARE(closingErrorMm(program), 0.0);
    Machine machine;
    machine.maxMotorRpm = 20000;
    const AxisMotion jumping = solved(program, machine);
    const Refusal* jump = find(jumping, Limit::WrapJump);
    QVERIFY(jump != nullptr);
    QVERIFY(near(jump->actual, wrap.speedMmPerDeg * 360));
    QVERIFY(near(jump->allowed, 100)); // 50 000 mm/s^2 for 2 ms
    QCOMPARE(jump->nearest.size(), std::size_t{1});
    PointCamProgram slower = program;
    slower.masterRateRevPerMin = jump->nearest.front().value;
    QVERIFY(solved(slower, machine).broken.empty());
    const PointCamProgram smooth = repaired(program);
    QVERIFY(wrapCheck(smooth).isSmooth);
    QVERIFY(smooth.knots == program.knots);
    QVERIFY(find(solved(smooth, machine), Limit::WrapJump) == nullptr);
    program.ends = SplineEnds::Clamped; // no speed at the wrap: only the acceleration may jump
    program.knots[1].slaveMm = 220;
    QVERIFY(std::abs(wrapCheck(program).speedMmPerDeg) < 1e-12);
    QVERIFY(std::abs(wrapCheck(program).accelerationMmPerDeg2) > 1e-6);
}

void TestPointCam::nearlyClosedIsClosedByRepair()
{
    PointCamProgram program;
    program.knots.back().slaveMm = 0.4; // 0.8 % of the span of 50
    WrapCheck wrap = wrapCheck(program);
    QVERIFY(near(closingErrorMm(program), 0.4)); // the table closes it
    QCOMPARE(wrap.advanceMm, 0.0);
    QVERIFY(wrap.isSmooth);
    QCOMPARE(repaired(program).knots.back().slaveMm, 0.0);
    QVERIFY(wrapCheck(repaired(program)).isSmooth);
    program.knots.back().slaveMm = 0.6; // meant as net advance
    wrap = wrapCheck(program);
    QCOMPARE(closingErrorMm(program), 0.0);
    QVERIFY(near(wrap.advanceMm, 0.6));
    QVERIFY(wrap.isSmooth); // periodic with a net advance
    QCOMPARE(repaired(program).knots.back().slaveMm, 0.6);
    QVERIFY(wrapCheck(repaired(knifeCam())).isSmooth);
}

void TestPointCam::insertsOnTheCurve()
{
    PointCamProgram program = knifeCam();
    const Spline before = camCurve(program);
    QCOMPARE(insertKnot(program, 100.00004).value_or(0), std::size_t{2});
    QCOMPARE(program.knots.at(2).masterDeg, 100.0);
    QVERIFY(std::abs(program.knots.at(2).slaveMm - before.at(100).value) <= 0.5e-3 + 1e-9);
    for (int deg = 0; deg <= 360; ++deg) // within the rounding of the new knot
        QVERIFY(std::abs(camCurve(program).at(deg).value - before.at(deg).value) < 1e-3);
    QCOMPARE(insertKnot(program, -5).value_or(0), std::size_t{1});
    QCOMPARE(program.knots.at(1).masterDeg, 0.1);
    QCOMPARE(insertKnot(program, 400).value_or(0), std::size_t{7});
    QCOMPARE(program.knots.at(7).masterDeg, 359.9);
    QVERIFY(!insertKnot(program, 0.05).has_value()); // no space
    QVERIFY(!insertKnot(program, noNumber).has_value());
    while (program.knots.size() < maxKnots)
        QVERIFY(insertKnot(program, 1.0 + static_cast<double>(program.knots.size()) * 3).has_value());
    QVERIFY(!insertKnot(program, 355).has_value());
    QVERIFY(!checkKnots(program.knots).has_value());
}

void TestPointCam::removesAndMoves()
{
    PointCamProgram program = knifeCam();
    QVERIFY(!removeKnot(program, 0));
    QVERIFY(!removeKnot(program, 5));
    QVERIFY(!removeKnot(program, 99));
    QVERIFY(removeKnot(program, 2));
    QVERIFY(!removeKnot(program, 2)); // five are left
    QVERIFY(moveKnot(program, 1, {77.77777, 12.34567}) == (Knot{77.7778, 12.346}));
    QVERIFY(moveKnot(program, 1, {250, 1e9}) == (Knot{199.9, 1e6}));
    QVERIFY(moveKnot(program, 1, {-50, -1e9}) == (Knot{0.1, -1e6}));
    QVERIFY(moveKnot(program, 1, {noNumber, noNumber}) == (Knot{0.1, -1e6}));
    QVERIFY(moveKnot(program, 0, {50, 3}) == (Knot{0, 3}));
    QCOMPARE(program.knots.back().slaveMm, 376.991); // progressive: the other end stays
    QVERIFY(!checkKnots(program.knots).has_value());
    PointCamProgram closed;
    QVERIFY(moveKnot(closed, 4, {300, 5}) == (Knot{360, 5}));
    QCOMPARE(closed.knots.front().slaveMm, 5.0);
    closed.ends = SplineEnds::Clamped;
    moveKnot(closed, 4, {300, 6});
    QCOMPARE(closed.knots.front().slaveMm, 5.0);
}

CAMPANEL_TEST(TestPointCam)

} // namespace test_point_cam

#include "test_point_cam.moc"
