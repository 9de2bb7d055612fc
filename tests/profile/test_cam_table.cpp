// SPDX-License-Identifier: Apache-2.0
// The cam-point table: exact advance, rows on the curve, stated errors, refusals, and seeded random cams from
// knots to rows.
#include "move_checks.h"
#include "random_cams.h"
#include "random_cases.h"

#include "profile/cam/cam_table.h"
#include "profile/cam/point_cam_edit.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

namespace test_cam_table {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 20240307;
const int camCount = campanel::test::randomCases();

MotionProfile moveOf(LawId law, double distanceMm, double durationS)
{
    MotionProfile motion;
    const Law& found = *findLaw(law);
    motion.addDisplacement(durationS, distanceMm, found, defaultParameters(found));
    return motion;
}

// A knife of circumference 376.991 mm (2 pi 60, 3 decimals), 100 mm and 10 000 pulses per motor revolution.
PointCamProgram knifeCam()
{
    PointCamProgram program;
    program.knots = {{0, 0}, {60, 80}, {150, 140}, {200, 230}, {290, 300}, {360, 376.991}};
    program.masterRateRevPerMin = 30;
    return program;
}

CamTable built(const PointCamProgram& program, const Machine& machine = {})
{
    const auto table = buildCamTable(program, machine);
    if (!table)
        qFatal("%s", describe(table.error()).c_str());
    return *table;
}

// The machine of the servo paper: a 6000 mm move in a second at 6750 r/min needs a fast output.
Machine fastMachine()
{
    Machine machine;
    machine.maxPulseFrequencyHz = 4000000;
    return machine;
}

// Returns the sum of the rows after this many cycles, by the controller's accumulator.
std::int64_t pulsesAfter(const PulsesPerCycle& advance, std::int64_t cycles)
{
    std::int64_t position = 0;
    std::int64_t owed = 0;
    for (std::int64_t i = 0; i < cycles; ++i) {
        position += advance.whole;
        owed += advance.remainder;
        if (owed >= advance.divisor) {
            owed -= advance.divisor;
            ++position;
        }
    }
    return position;
}

void verifyRows(const CamRecipe& recipe, const CamTable& table)
{
    const MotionProfile motion = forwardMotion(recipe.program);
    const double units = 256 * axisPulsesPerMm(recipe.machine);
    QCOMPARE(table.rows.size(), static_cast<std::size_t>(recipe.program.camPoints) + 1);
    QCOMPARE(table.rows.front().position256, 0);
    const double ticks = camCycleS(recipe.program) * recipe.machine.timerClockHz;
    QVERIFY(std::abs(table.cycleTicks - ticks) <= 0.5 + 1e-3);
    const double netMm = netAdvanceMm(recipe.program) * recipe.program.slaveScale;
    // The last row is the exact advance, rounded, and so is the sum of a million cycles.
    QVERIFY(std::abs(table.rows.back().position256 - 256 * table.advance.asDouble()) <= 0.5 + 1e-3);
    QVERIFY(std::abs(table.advance.asDouble() - netMm * axisPulsesPerMm(recipe.machine)) <=
            1e-9 * std::max(1.0, std::abs(table.advance.asDouble())));
    QVERIFY(table.advance.remainder >= 0 && table.advance.remainder < table.advance.divisor);
    for (std::size_t i = 0; i < table.rows.size(); i += 37) {
        const double timeS = motion.durationS() * static_cast<double>(i) / recipe.program.camPoints;
        const double exact = units * (motion.at(timeS).positionMm - motion.at(0).positionMm);
        QVERIFY(std::abs(table.rows[i].position256 - exact) <= 0.5 + 1e-9 * std::abs(exact) + 1e-3);
    }
    if (wrapCheck(recipe.program).isSmooth)
        QVERIFY(std::abs(table.rows.front().slope256 - table.rows.back().slope256) <= 1);
}

void verifyMotion(const CamRecipe& recipe, const AxisMotion& cam)
{
    const auto segments = cam.motion.segments();
    const double room = 1e-9 * std::max(1.0, std::abs(recipe.program.slaveScale) * 1000);
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        const MotionPoint before = segments[i].at(segments[i].endS());
        const MotionPoint after = segments[i + 1].at(segments[i + 1].startS);
        QVERIFY(std::abs(before.positionMm - after.positionMm) <= room);
        const bool isWrap = recipe.program.ends == SplineEnds::Natural; // its speed may jump there
        QVERIFY(isWrap ||
                std::abs(before.velocityMmPerS - after.velocityMmPerS) <= 1e-8 * (1 + cam.peaks.speedMmPerS));
    }
    const double netMm = netAdvanceMm(recipe.program) * recipe.program.slaveScale;
    const double sign = recipe.program.masterRateRevPerMin > 0 ? 1 : -1;
    const Segment& last = segments.back();
    QVERIFY(std::abs(last.at(last.endS()).positionMm - cam.motion.at(0).positionMm - sign * netMm) <= room);
    for (int i = 0; cam.broken.empty() && i <= 300; ++i) {
        const MotionPoint p = cam.motion.at(cam.motion.durationS() * i / 300);
        QVERIFY(std::abs(p.accelerationMmPerS2) <= recipe.machine.maxAccelerationMmPerS2 * (1 + 1e-6));
        QVERIFY(std::abs(p.velocityMmPerS) * axisRpmPerMmPerS(recipe.machine) <=
                recipe.machine.maxMotorRpm * (1 + 1e-6));
        QVERIFY(std::abs(p.velocityMmPerS) * axisPulsesPerMm(recipe.machine) <=
                recipe.machine.maxPulseFrequencyHz * (1 + 1e-6));
    }
    if (cam.broken.empty()) {
        QVERIFY(cam.peaks.torqueNm <= recipe.machine.maxTorqueNm * (1 + 1e-6));
        QVERIFY(recipe.machine.ratedTorqueNm == 0 ||
                cam.peaks.rmsTorqueNm <= recipe.machine.ratedTorqueNm * (1 + 1e-6));
    }
    for (const Refusal& refusal : cam.broken) {
        for (const Suggestion& s : refusal.nearest) {
            PointCamProgram mended = recipe.program;
            setValue(mended, s.field, s.value);
            const auto again = solve(mended, recipe.machine);
            QVERIFY2(again && again->broken.empty(), describe(refusal).c_str());
        }
    }
}

} // namespace

class TestCamTable : public QObject {
    Q_OBJECT

private slots:
    void rowsOfAQuinticMove();
    void statesTheInterpolationError_data();
    void statesTheInterpolationError();
    void statedErrorsAreTheRealOnes();
    void statedErrorsOfEveryLaw();
    void statedErrorsWithJointsOnRows();
    void advanceIsExact_data();
    void advanceIsExact();
    void slopesContinueAtTheWrap();
    void directionAndPhaseOfTheTable();
    void refusals();
    void randomCams();

private:
    static void verifyErrors(const CamTable& table, const MotionProfile& motion, const Machine& machine,
                             CamUse use, int parts);
};

void TestCamTable::rowsOfAQuinticMove()
{
    // s(0.1) = 6000 * 0.00856 = 51.36 mm = 5136 pulses; s'(0.1) = 6000 * 0.243 = 1458 mm/s.
    const auto table = buildCamTable(moveOf(LawId::Quintic, 6000, 1), 100, fastMachine(), CamUse::Once);
    QVERIFY(table.has_value());
    QCOMPARE(table->rows.size(), std::size_t{101});
    QCOMPARE(table->cycleTicks, 8000000U);
    QVERIFY(table->rows[0] == (CamRow{0, 0}));
    QCOMPARE(table->rows[10].position256, 5136 * 256);
    QVERIFY(std::abs(table->rows[10].slope256 / (1458.0 * 256) - 1) < 1e-4);
    QCOMPARE(table->rows[50].position256, 300000 * 256);
    QVERIFY(table->rows[100] == (CamRow{600000 * 256, 0}));
    QCOMPARE(table->advance.whole, std::int64_t{600000});
    QCOMPARE(table->advance.remainder, std::int64_t{0});
    QCOMPARE(table->advance.divisor, std::int64_t{1});
    const auto back = buildCamTable(moveOf(LawId::Quintic, -6000, 1), 100, fastMachine(), CamUse::Once);
    QVERIFY(back.has_value());
    for (std::size_t i = 0; i <= 100; ++i)
        QCOMPARE(back->rows[i].position256, -table->rows[i].position256);
    QCOMPARE(back->advance.whole, std::int64_t{-600000});
}

void TestCamTable::statesTheInterpolationError_data()
{
    QTest::addColumn<int>("points");
    QTest::addColumn<double>("maxMm");
    QTest::addColumn<double>("maxMmPerS");
    // A clamped spline of a smooth curve has an error of at most 5/384 h^4 max|s''''| in position and h^3 /
    // 24 max|s''''| in speed; s'''' = 6000 (720 x - 360), at most 2 160 000 mm/s^4. Rows are rounded to 1/256
    // pulse (0.00004 mm), slopes likewise.
    QTest::newRow("100 points") << 100 << 5.0 / 384 * 1e-8 * 2160000 << 1e-6 / 24 * 2160000;
    QTest::newRow("1000 points") << 1000 << 5.0 / 384 * 1e-12 * 2160000 << 1e-9 / 24 * 2160000;
}

void TestCamTable::statesTheInterpolationError()
{
    QFETCH(int, points);
    QFETCH(double, maxMm);
    QFETCH(double, maxMmPerS);
    const MotionProfile motion = moveOf(LawId::Quintic, 6000, 1);
    const Machine machine = fastMachine();
    const auto table = buildCamTable(motion, points, machine, CamUse::Once);
    QVERIFY(table.has_value());
    const CamErrors errors = camErrors(*table, motion, machine, CamUse::Once);
    qInfo("%d points: %.3g mm (%.3g pulses) at %.4f s, %.3g mm/s at %.4f s", points, errors.positionMm,
          errors.positionPulses, errors.positionTimeS, errors.speedMmPerS, errors.speedTimeS);
    const double rounding = 1 / 25600.0; // mm
    QVERIFY(errors.positionMm <= maxMm + rounding);
    QVERIFY(errors.positionMm > 0);
    QCOMPARE(errors.positionPulses, errors.positionMm * 100);
    // Half a unit for each of two positions and two slopes, over an interval.
    QVERIFY(errors.speedMmPerS <= maxMmPerS + 2 * rounding * points);
    QVERIFY(errors.speedMmPerS > maxMmPerS / 10);
}

// Replays each interval at many places: no error is larger than stated, nor much smaller.
void TestCamTable::verifyErrors(const CamTable& table, const MotionProfile& motion, const Machine& machine,
                                CamUse use, int parts)
{
    const double units = 256 * axisPulsesPerMm(machine);
    const auto intervals = static_cast<double>(table.rows.size() - 1);
    double positionMm = 0;
    double speedMmPerS = 0;
    const double startMm = motion.at(0).positionMm;
    const auto look = [&](double place, const MotionPoint& exact) { // place: an interval and its share
        const auto index = static_cast<std::size_t>(std::min(place, intervals - 1));
        const CamPoint point = interpolate(table, index, place - static_cast<double>(index));
        const double speed = point.slope256 / units * intervals / motion.durationS();
        positionMm = std::max(positionMm, std::abs(point.position256 / units - (exact.positionMm - startMm)));
        speedMmPerS = std::max(speedMmPerS, std::abs(speed - exact.velocityMmPerS));
    };
    for (int i = 0; i <= static_cast<int>(intervals) * parts; ++i) {
        const double place = static_cast<double>(i) / parts;
        look(place, motion.at(place * motion.durationS() / intervals));
    }
    for (const Segment& segment : motion.segments()) { // its speed may jump there
        look(segment.startS / motion.durationS() * intervals, segment.at(segment.startS));
        look(segment.endS() / motion.durationS() * intervals, segment.at(segment.endS()));
    }
    const CamErrors errors = camErrors(table, motion, machine, use);
    const auto agrees = [](double stated, double real) {
        return stated >= real * (1 - 1e-9) - 1e-9 && stated <= real * 1.02 + 1e-7;
    };
    QVERIFY2(agrees(errors.positionMm, positionMm),
             qPrintable(QStringLiteral("%1 stated, %2 mm").arg(errors.positionMm).arg(positionMm)));
    QVERIFY2(agrees(errors.speedMmPerS, speedMmPerS),
             qPrintable(QStringLiteral("%1 stated, %2 mm/s").arg(errors.speedMmPerS).arg(speedMmPerS)));
}

void TestCamTable::statedErrorsAreTheRealOnes()
{
    const PointCamProgram program = knifeCam();
    const CamTable table = built(program);
    verifyErrors(table, forwardMotion(program), {}, CamUse::Repeats, 100);
    QVERIFY(camErrors(table, forwardMotion(program), {}, CamUse::Repeats).positionMm < 1e-3);
}

// Every law, as a displacement and as a ramp in both directions, with joints inside intervals.
void TestCamTable::statedErrorsOfEveryLaw()
{
    for (const Law& law : laws()) {
        LawParameters parameters = defaultParameters(law);
        if (!law.parameters.empty())
            parameters[0] = law.id == LawId::Exponential ? 20 : 0.33;
        std::vector<MotionProfile> motions(4);
        if (law.isDisplacementLaw)
            motions[0].addDisplacement(1, 600, law, parameters);
        motions[1].addRamp(1, 0, 600, law, parameters, false);
        motions[2].addRamp(1, 600, -200, law, parameters, true);
        motions[3].addConstant(0.2345, 100);
        motions[3].addRamp(0.7, 100, 300, law, parameters, false);
        for (const MotionProfile& motion : motions) {
            for (const int intervals : {101, 640}) {
                if (motion.segments().empty())
                    continue;
                const auto table = buildCamTable(motion, intervals, Machine{}, CamUse::Once);
                QVERIFY(table.has_value());
                verifyErrors(*table, motion, Machine{}, CamUse::Once, 100);
                if (QTest::currentTestFailed())
                    qWarning("%s, %d intervals", std::string(law.key).c_str(), intervals);
            }
        }
    }
}

// Joints of laws and segments fall on rows, but for the rounding of their times.
void TestCamTable::statedErrorsWithJointsOnRows()
{
    RandomValues random(seed);
    constexpr std::array ids{LawId::ModifiedSine, LawId::ModifiedTrapezoid, LawId::SCurve, LawId::Trapezoid};
    Machine machine;
    machine.pulsesPerMotorRev = 2500;
    for (int i = 0; i < 200; ++i) {
        const Law& law = *findLaw(ids[random.pick(ids.size())]);
        const LawParameters parameters{0.25, 0.5};
        const double durationS = snapToGrid(Field::MoveTime, random.uniform(0.5, 9));
        const int intervals = 40 * static_cast<int>(3 + random.pick(8));
        const double speed = random.uniform(-4000, 4000);
        MotionProfile motion;
        if (law.isSpeedLaw)
            motion.addRamp(durationS, 0, speed, law, parameters, random.pick(2) == 0);
        else
            motion.addDisplacement(durationS, speed, law, parameters);
        if (random.pick(2) == 0) { // a joint of two segments on the middle row
            const double endMmPerS = motion.at(durationS).velocityMmPerS;
            motion.addRamp(durationS, endMmPerS, 100, *findLaw(LawId::Quintic), {}, false);
        }
        const auto table = buildCamTable(motion, intervals, machine, CamUse::Once);
        QVERIFY(table.has_value());
        verifyErrors(*table, motion, machine, CamUse::Once, 64);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QStringLiteral("case %1: %2, %3 intervals, %4 s")
                                 .arg(i)
                                 .arg(QString::fromUtf8(law.key.data()))
                                 .arg(intervals)
                                 .arg(durationS)));
    }
}

void TestCamTable::advanceIsExact_data()
{
    QTest::addColumn<double>("slaveScale");
    QTest::addColumn<int>("pulsesPerRev");
    QTest::addColumn<double>("feed");
    QTest::addColumn<qint64>("whole");
    QTest::addColumn<qint64>("remainder");
    QTest::addColumn<qint64>("divisor");
    // 376.991 mm * K / feed = 376991 K / (1000 feed), by hand.
    QTest::newRow("whole tenths") << 1.0 << 10000 << 100.0 << qint64{37699} << qint64{1} << qint64{10};
    QTest::newRow("thirds") << 1.0 << 10000 << 30.0 << qint64{125663} << qint64{2} << qint64{3};
    QTest::newRow("backwards") << -1.0 << 10000 << 100.0 << qint64{-37700} << qint64{9} << qint64{10};
    QTest::newRow("scaled") << 1.001 << 10000 << 100.0 << qint64{37736} << qint64{7991} << qint64{10000};
    QTest::newRow("awkward feed") << 1.0 << 9999 << 94.247 << qint64{39996} << qint64{29997} << qint64{94247};
}

void TestCamTable::advanceIsExact()
{
    QFETCH(double, slaveScale);
    QFETCH(int, pulsesPerRev);
    QFETCH(double, feed);
    QFETCH(qint64, whole);
    QFETCH(qint64, remainder);
    QFETCH(qint64, divisor);
    PointCamProgram program = knifeCam();
    program.slaveScale = slaveScale;
    Machine machine;
    machine.pulsesPerMotorRev = pulsesPerRev;
    machine.feedMmPerMotorRev = feed;
    for (const double phase : {0.0, 123.4}) {
        program.phaseDeg = phase;
        const CamTable table = built(program, machine);
        QCOMPARE(qint64{table.advance.whole}, whole);
        QCOMPARE(qint64{table.advance.remainder}, remainder);
        QCOMPARE(qint64{table.advance.divisor}, divisor);
        constexpr std::int64_t cycles = 1000000;
        QCOMPARE(pulsesAfter(table.advance, cycles), whole * cycles + remainder * cycles / divisor);
    }
    // Integers only: the fraction matches the entered numbers to the last digit.
    const qint64 scale1000 = std::llround(slaveScale * 1000);
    const qint64 feed1000 = std::llround(feed * 1000);
    QCOMPARE((whole * divisor + remainder) * feed1000 * 1000, 376991 * scale1000 * pulsesPerRev * divisor);
}

void TestCamTable::slopesContinueAtTheWrap()
{
    const CamTable smooth = built(knifeCam());
    QCOMPARE(smooth.rows.front().slope256, smooth.rows.back().slope256);
    QVERIFY(smooth.rows.front().slope256 > 0);
    PointCamProgram program = knifeCam();
    program.ends = SplineEnds::Clamped;
    const CamTable clamped = built(program);
    QCOMPARE(clamped.rows.front().slope256, 0);
    QCOMPARE(clamped.rows.back().slope256, 0);
    program.ends = SplineEnds::Natural; // its own slopes on either side: no ringing beside the jump
    const CamTable natural = built(program);
    const MotionProfile motion = forwardMotion(program);
    const CamErrors errors = camErrors(natural, motion, {}, CamUse::Repeats);
    const double jump = wrapCheck(program).speedMmPerDeg * 180; // 30 r/min
    QVERIFY(std::abs(errors.wrapSpeedStepMmPerS - std::abs(jump)) < 0.1);
    QVERIFY(errors.positionMm < 1e-3);
    QCOMPARE(camErrors(smooth, forwardMotion(knifeCam()), {}, CamUse::Repeats).wrapSpeedStepMmPerS, 0.0);
}

void TestCamTable::directionAndPhaseOfTheTable()
{
    PointCamProgram program = knifeCam();
    const CamTable forwards = built(program);
    program.masterRateRevPerMin = -30; // the controller runs the same rows backward
    QVERIFY(built(program).rows == forwards.rows);
    program.masterRateRevPerMin = 15; // a slower master: the same rows in twice the time
    QVERIFY(built(program).rows == forwards.rows);
    QCOMPARE(built(program).cycleTicks, 2 * forwards.cycleTicks);
    program.phaseDeg = 90; // a quarter of 1000 rows later
    const CamTable late = built(program);
    const std::int32_t start = forwards.rows[250].position256;
    for (std::size_t i = 0; i <= 750; i += 10)
        QVERIFY(std::abs(late.rows[i].position256 - (forwards.rows[250 + i].position256 - start)) <= 1);
    const auto advance = static_cast<std::int32_t>(std::llround(376.991 * 25600));
    for (std::size_t i = 0; i <= 250; i += 10)
        QVERIFY(std::abs(late.rows[750 + i].position256 - (forwards.rows[i].position256 + advance - start)) <=
                1);
}

void TestCamTable::refusals()
{
    PointCamProgram program = knifeCam();
    program.camPoints = 99;
    auto table = buildCamTable(program, {});
    QVERIFY(!table && table.error().limit == Limit::FieldRange);
    QCOMPARE(table.error().nearest.size(), std::size_t{1});
    QCOMPARE(table.error().nearest.front().value, 100.0);
    program = knifeCam();
    program.masterRateRevPerMin = 900;
    table = buildCamTable(program, {});
    QVERIFY(!table && table.error().limit == Limit::MasterTooFast);
    QVERIFY(table.error().actual > 200000 && table.error().allowed == 200000);
    program.masterRateRevPerMin = table.error().nearest.at(0).value;
    QVERIFY(program.masterRateRevPerMin > 100);
    QVERIFY(buildCamTable(program, {}).has_value());
    program.masterRateRevPerMin += 0.1;
    QVERIFY(!buildCamTable(program, {}).has_value());
    // 2^31 / 256 pulses are 83 886.08 mm at 100 pulses per mm.
    QVERIFY(buildCamTable(moveOf(LawId::Quintic, 83886, 100), 100, {}, CamUse::Once).has_value());
    for (const double distance : {83887.0, -1e6}) {
        const auto far = buildCamTable(moveOf(LawId::Quintic, distance, 600), 100, {}, CamUse::Once);
        QVERIFY(!far && far.error().limit == Limit::TableRange);
        QVERIFY(far.error().actual > far.error().allowed);
    }
    // Forward and back: no advance, but rows that do not fit.
    MotionProfile bothWays = moveOf(LawId::Quintic, 90000, 200);
    const Law& law = *findLaw(LawId::Quintic);
    bothWays.addDisplacement(200, -90000, law, {});
    QVERIFY(buildCamTable(bothWays, 100, {}, CamUse::Once).error().limit == Limit::TableRange);
    // 8 MHz overflow 32 bits after 536.87 s.
    const auto slow = buildCamTable(moveOf(LawId::Quintic, 1000, 537), 100, {}, CamUse::Once);
    QVERIFY(!slow && slow.error().limit == Limit::TableRange && slow.error().field == Field::TimerClock);
}

void TestCamTable::randomCams()
{
    qInfo("seed %u, %d cams", seed, camCount);
    RandomCams random(seed);
    int refused = 0;
    int broken = 0;
    int tables = 0;
    for (int i = 0; i < camCount && !QTest::currentTestFailed(); ++i) {
        const CamRecipe recipe = random.next();
        const auto cam = solve(recipe.program, recipe.machine);
        if (!cam) {
            ++refused;
            continue;
        }
        verifyMotion(recipe, *cam);
        const auto table = buildCamTable(recipe.program, recipe.machine);
        if (!cam->broken.empty())
            ++broken;
        if (!table) {
            QVERIFY(table.error().limit == Limit::TableRange || !cam->broken.empty());
            continue;
        }
        ++tables;
        verifyRows(recipe, *table);
        if (tables % 50 == 0)
            verifyErrors(*table, forwardMotion(recipe.program), recipe.machine, CamUse::Repeats, 64);
    }
    qInfo("%d refused, %d beyond a limit, %d tables", refused, broken, tables);
    if (QTest::currentTestFailed())
        return;
    QVERIFY(refused > camCount / 50 && broken > camCount / 50 && tables > camCount / 50);
}

CAMPANEL_TEST(TestCamTable)

} // namespace test_cam_table

#include "test_cam_table.moc"
