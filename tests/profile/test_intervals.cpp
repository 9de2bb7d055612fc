// SPDX-License-Identifier: Apache-2.0
// The compiler of intervals: sums, joints and errors of its tables, checked iteration by iteration; the
// number of rows against known shapes and against the fewest straight lines.
#include "profile/intervals/intervals.h"
#include "profile/laws/laws.h"
#include "random_cases.h"
#include "recipes.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace test_intervals {

using namespace campanel::profile;

namespace {

constexpr double k = 1.00663296; // 2^23 / (50e6 / 6)

const Law& lawOf(LawId id)
{
    return *std::ranges::find(laws(), id, &Law::id);
}

MotionProfile move(LawId id, double distanceMm, double durationS)
{
    MotionProfile motion;
    motion.addDisplacement(durationS, distanceMm, lawOf(id), defaultParameters(lawOf(id)));
    return motion;
}

MotionProfile ramp(LawId id, double fromMmPerS, double toMmPerS, double durationS)
{
    MotionProfile motion;
    motion.addRamp(durationS, fromMmPerS, toMmPerS, lawOf(id), defaultParameters(lawOf(id)), false);
    return motion;
}

// Returns a machine fast enough for every motion here.
Machine machineOf(double pulsesPerMm)
{
    Machine machine;
    machine.feedMmPerMotorRev = machine.pulsesPerMotorRev / pulsesPerMm;
    return machine;
}

// 0 -> 200 mm/s in 0.2 s, 0.5 s, back in 0.25 s: 2000, 10000 and 2500 pulses.
MotionProfile trapezoid(double sign = 1)
{
    MotionProfile motion;
    motion.addCubic(0.2, 0, sign * 1000, 0);
    motion.addConstant(0.5, sign * 200);
    motion.addCubic(0.25, sign * 200, sign * -800, 0);
    return motion;
}

std::string reason(const tl::expected<IntervalTable, Refusal>& table)
{
    return table ? std::string() : describe(table.error());
}

// Dist >= |V1^2 - V0^2| / (2 Acc), in whole numbers: every product is below 2^63.
bool fitsItsDistance(const IntervalRow& row, int fractionBits)
{
    const std::uint64_t sum = std::uint64_t{row.firstSpeed} + row.lastSpeed;
    const std::uint64_t change =
        row.firstSpeed > row.lastSpeed ? row.firstSpeed - row.lastSpeed : row.lastSpeed - row.firstSpeed;
    if (change == 0)
        return true;
    const std::uint64_t twice = (std::uint64_t{row.acceleration} * 2) << fractionBits;
    return row.acceleration != 0 && (sum * change + twice - 1) / twice <= row.pulses;
}

// Returns the violated property of a table; empty when all hold.
QString broken(const IntervalTable& table, double speedErrorMmPerS)
{
    std::int64_t pulses = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const IntervalRow& row = table.rows[i];
        pulses += row.pulses;
        if (row.pulses == 0 || row.firstSpeed == 0 || row.lastSpeed == 0)
            return QStringLiteral("row %1 has a zero").arg(i);
        if (i > 0 && row.firstSpeed != table.rows[i - 1].lastSpeed)
            return QStringLiteral("the speed jumps before row %1").arg(i);
        if (!fitsItsDistance(row, table.fractionBits))
            return QStringLiteral("the ramp of row %1 is longer than its distance").arg(i);
    }
    if (pulses != std::abs(table.advance))
        return QStringLiteral("%1 pulses, not %2").arg(pulses).arg(table.advance);
    if (!(table.errors.speedMmPerS <= speedErrorMmPerS))
        return QStringLiteral("speed error %1").arg(table.errors.speedMmPerS);
    return {};
}

// Returns the time of the last pulse by the flow chart of the paper.
double plainTimeS(const IntervalTable& table)
{
    std::uint64_t iterations = 0;
    std::uint64_t position = 0;
    const std::uint64_t capacity = std::uint64_t{1} << (23 + table.fractionBits);
    for (const IntervalRow& row : table.rows) {
        std::uint64_t speed = row.firstSpeed;
        std::uint64_t rest = 0;
        for (std::uint32_t pulses = 0; pulses < row.pulses;) {
            ++iterations;
            rest += row.acceleration;
            for (; rest >= 1u << 23u; rest -= 1u << 23u)
                speed += speed < row.lastSpeed ? 1u : (speed > row.lastSpeed ? ~std::uint64_t{0} : 0u);
            position += speed;
            if (position >= capacity) {
                position -= capacity;
                ++pulses;
            }
        }
    }
    return static_cast<double>(iterations) * 6 / 50e6;
}

// Returns the largest errors by the flow chart of the paper. Samples are `stride` iterations apart, closer at
// the ends of the rows and of the motion, until both are at rest or have continued for a tenth of the time.
IntervalErrors replayed(const IntervalTable& table, const MotionProfile& motion, double pulsesPerMm,
                        IntervalMode mode, std::uint64_t stride)
{
    const double iterationS = mode == IntervalMode::Published ? std::ldexp(1.0, -23) : 6 / 50e6;
    const double duration = motion.durationS();
    const MotionPoint start = motion.at(0);
    const MotionPoint last = motion.at(duration);
    const double sign = last.positionMm < start.positionMm ? -1 : 1;
    const bool stands = std::abs(last.velocityMmPerS) * duration < 1e-6 * std::abs(last.positionMm);
    const double unit = std::ldexp(1.0, -23 - table.fractionBits);
    IntervalErrors result;
    std::uint64_t iterations = 0;
    std::uint64_t travelled = 0; // position accumulator with the pulses given
    const auto compare = [&](double speed) {
        const double time = static_cast<double>(iterations) * iterationS;
        MotionPoint here = time < duration ? motion.at(time) : last;
        if (time >= duration && stands)
            here.velocityMmPerS = 0;
        here.positionMm += here.velocityMmPerS * std::max(0.0, time - duration);
        const double tableMmPerS = speed * unit / iterationS / pulsesPerMm;
        result.speedMmPerS = std::max(result.speedMmPerS, std::abs(tableMmPerS - sign * here.velocityMmPerS));
        result.positionPulses = std::max(result.positionPulses,
                                         std::abs(static_cast<double>(travelled) * unit -
                                                  sign * (here.positionMm - start.positionMm) * pulsesPerMm));
    };
    const auto end = static_cast<std::uint64_t>(duration / iterationS);
    std::uint64_t given = 0;
    std::uint64_t speed = 0;
    for (const IntervalRow& row : table.rows) {
        speed = row.firstSpeed;
        compare(static_cast<double>(speed));
        given += std::uint64_t{row.pulses} << (23 + table.fractionBits);
        for (std::uint64_t rest = 0; travelled < given;) {
            ++iterations;
            rest += row.acceleration;
            for (; rest >= 1u << 23u; rest -= 1u << 23u)
                speed += speed < row.lastSpeed ? 1u : (speed > row.lastSpeed ? ~std::uint64_t{0} : 0u);
            travelled += speed;
            if (iterations % stride == 0 || travelled + stride * speed >= given || iterations == end ||
                iterations == end + 1)
                compare(static_cast<double>(speed));
        }
    }
    const std::uint64_t over = std::max(iterations, end) + end / 10;
    const std::uint64_t step = stands ? 0 : speed;
    compare(static_cast<double>(step));
    for (; iterations < over; ++iterations, travelled += step) {
        if (iterations % stride == 0 || iterations == end)
            compare(static_cast<double>(step));
    }
    return result;
}

// Returns the step of the speed register: a unit, or the change in an iteration.
double stepMmPerS(const IntervalTable& table, double pulsesPerMm)
{
    double units = 1;
    for (const IntervalRow& row : table.rows)
        units = std::max(units, std::ldexp(row.acceleration, -23));
    return std::ldexp(units, -table.fractionBits) / pulsesPerMm;
}

// Returns the largest acceleration of a row over the largest of the motion.
double steepness(const IntervalTable& table, const MotionProfile& motion)
{
    double ofMotion = 0;
    for (const Segment& segment : motion.segments()) {
        for (int i = 0; i <= 200; ++i)
            ofMotion = std::max(
                ofMotion,
                std::abs(segment.at(segment.startS + segment.durationS * i / 200).accelerationMmPerS2));
    }
    double ofRows = 0;
    for (const IntervalRow& row : table.rows) {
        const double scale = 100 * std::ldexp(table.fractionBits == 0 ? 1 : k, table.fractionBits);
        const double v0 = row.firstSpeed / scale;
        const double v1 = row.lastSpeed / scale;
        ofRows = std::max(ofRows, std::abs(v1 * v1 - v0 * v0) / (2 * row.pulses / 100.0));
    }
    return ofRows / ofMotion;
}

} // namespace

class TestIntervals : public QObject {
    Q_OBJECT

private slots:
    void trapezoidIsTwoRows_data();
    void trapezoidIsTwoRows();
    void timeIsTheAccumulators_data();
    void timeIsTheAccumulators();
    void laws_data();
    void laws();
    void cutter();
    void speedsAtTheEndsAreExact_data();
    void speedsAtTheEndsAreExact();
    void statedErrorsAreNotBelowTheTrueOnes_data();
    void statedErrorsAreNotBelowTheTrueOnes();
    void rowsEndWithAStretch_data();
    void rowsEndWithAStretch();
    void fewestLinesKeepTheWholeError();
    void largerErrorsNeedNoMoreRows_data();
    void largerErrorsNeedNoMoreRows();
    void refusals();
    void refusedErrorNamesOneThatIsKept_data();
    void refusedErrorNamesOneThatIsKept();
    void randomMoves();
};

void TestIntervals::trapezoidIsTwoRows_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<double>("sign");
    QTest::newRow("published") << 0 << 1.0;
    QTest::newRow("corrected") << 1 << 1.0;
    QTest::newRow("backwards") << 1 << -1.0;
}

void TestIntervals::trapezoidIsTwoRows()
{
    QFETCH(int, mode);
    QFETCH(double, sign);
    const auto table = compileIntervals(trapezoid(sign), Machine{}, 2, static_cast<IntervalMode>(mode));
    QVERIFY(table);
    QCOMPARE(broken(*table, 0.2), QString());
    QCOMPARE(table->rows.size(), std::size_t{2});
    QCOMPARE(table->minLinks, 3);
    QCOMPARE(table->advance, static_cast<std::int64_t>(sign * 14500));
    QVERIFY(std::abs(table->rows[0].pulses - 12000.0) <= 3);
    const double unit = mode == 0 ? 1 : 256 * k;
    QVERIFY(std::abs(table->rows[0].lastSpeed / unit - 20000) < 10);
    const double accelerationUnit = mode == 0 ? 1 : 256 * k * k;
    QVERIFY(std::abs(table->rows[0].acceleration / accelerationUnit - 100'000) < 100);
    QVERIFY(std::abs(table->rows[1].acceleration / accelerationUnit - 80'000) < 100);
    // The published registers run k times slower; rest is reached only to a thousandth of a pulse.
    QVERIFY(std::abs(table->timeS - 0.95 * (mode == 0 ? k : 1)) < 0.003);
}

void TestIntervals::timeIsTheAccumulators_data()
{
    QTest::addColumn<int>("mode");
    QTest::newRow("published") << 0;
    QTest::newRow("corrected") << 1;
}

void TestIntervals::timeIsTheAccumulators()
{
    QFETCH(int, mode);
    const auto table =
        compileIntervals(move(LawId::ModifiedSine, 600, 1), Machine{}, 10, static_cast<IntervalMode>(mode));
    QVERIFY(table);
    QVERIFY(std::abs(table->timeS - plainTimeS(*table)) < 1e-9);
    QCOMPARE(table->cycleTicks, static_cast<std::uint32_t>(std::ceil(table->timeS * 8e6 - 1e-6)));
}

void TestIntervals::laws_data()
{
    QTest::addColumn<int>("law");
    QTest::addColumn<double>("speedError");
    QTest::addColumn<int>("maxRows");
    // 600 mm in 1 s. A line of duration h deviates from a curve of constant jerk j by at least j h^2 / 16, or
    // j h^2 / 12 for the same distance. The cubic law (3600 mm/s at its peak speed of 900) needs 8 lines at
    // 10 mm/s, 25 at 1 mm/s.
    QTest::newRow("cubic, 10 mm/s") << static_cast<int>(LawId::Cubic) << 10.0 << 8;
    QTest::newRow("cubic, 1 mm/s") << static_cast<int>(LawId::Cubic) << 1.0 << 25;
    QTest::newRow("quintic, 10 mm/s") << static_cast<int>(LawId::Quintic) << 10.0 << 10;
    QTest::newRow("quintic, 1 mm/s") << static_cast<int>(LawId::Quintic) << 1.0 << 28;
    QTest::newRow("modified sine, 10 mm/s") << static_cast<int>(LawId::ModifiedSine) << 10.0 << 10;
    QTest::newRow("modified sine, 1 mm/s") << static_cast<int>(LawId::ModifiedSine) << 1.0 << 29;
    QTest::newRow("parabolic, 1 mm/s") << static_cast<int>(LawId::Parabolic) << 1.0 << 2;
}

void TestIntervals::laws()
{
    QFETCH(int, law);
    QFETCH(double, speedError);
    QFETCH(int, maxRows);
    const auto table = compileIntervals(move(static_cast<LawId>(law), 600, 1), Machine{}, speedError,
                                        IntervalMode::Corrected);
    QVERIFY(table);
    QCOMPARE(broken(*table, speedError), QString());
    QCOMPARE(table->advance, std::int64_t{60000});
    qInfo("%zu rows, speed error %.3f mm/s, position error %.2f pulses, %.3f us late", table->rows.size(),
          table->errors.speedMmPerS, table->errors.positionPulses,
          (table->timeS - table->profileTimeS) * 1e6);
    QVERIFY(static_cast<int>(table->rows.size()) <= maxRows);
    QVERIFY(std::abs(table->timeS - 1) < 5e-4);
}

// The knife of L = 250 mm, with the circumference as feed.
void TestIntervals::cutter()
{
    const test::Recipe recipe = test::checkRecipe();
    const auto knife = solve(recipe.program, recipe.machine);
    QVERIFY(knife);
    Machine machine = recipe.machine;
    machine.feedMmPerMotorRev = 2 * std::numbers::pi * machine.knifeRadiusMm;
    const auto table = compileIntervals(knife->motion, machine, 5, IntervalMode::Corrected);
    QVERIFY(table);
    QCOMPARE(broken(*table, 5), QString());
    QCOMPARE(table->advance, std::int64_t{10000});
    qInfo("%zu rows, speed error %.3f mm/s, %.3f us late", table->rows.size(), table->errors.speedMmPerS,
          (table->timeS - table->profileTimeS) * 1e6);
    QVERIFY(table->rows.size() <= 9);
    QVERIFY(std::abs(table->timeS - 1) < 1e-3);
}

void TestIntervals::speedsAtTheEndsAreExact_data()
{
    QTest::addColumn<double>("fromMmPerS");
    QTest::addColumn<double>("toMmPerS");
    QTest::newRow("from rest") << 0.0 << 100.0;
    QTest::newRow("to rest") << 250.0 << 0.0;
    QTest::newRow("up") << 100.0 << 1000.0;
    QTest::newRow("backwards, down") << -900.0 << -90.0;
}

// The last speed of a speed move is held to the end.
void TestIntervals::speedsAtTheEndsAreExact()
{
    QFETCH(double, fromMmPerS);
    QFETCH(double, toMmPerS);
    for (const Law& law : campanel::profile::laws()) {
        if (law.isDisplacementLaw)
            continue;
        LawParameters parameters{};
        for (std::size_t i = 0; i < law.parameters.size(); ++i)
            parameters[i] = law.parameters[i].defaultValue;
        MotionProfile motion;
        motion.addRamp(0.4, fromMmPerS, toMmPerS, law, parameters, false);
        const auto table = compileIntervals(motion, Machine{}, 5, IntervalMode::Corrected);
        QVERIFY2(table, law.key.data());
        QCOMPARE(broken(*table, 5), QString());
        const double unitsPerMm = 100 * 256 * k;
        if (fromMmPerS != 0)
            QVERIFY(std::abs(table->rows.front().firstSpeed - std::abs(fromMmPerS) * unitsPerMm) <= 0.5001);
        if (toMmPerS != 0)
            QVERIFY(std::abs(table->rows.back().lastSpeed - std::abs(toMmPerS) * unitsPerMm) <= 0.5001);
    }
}

void TestIntervals::refusals()
{
    const Machine machine;
    const auto limit = [&](const MotionProfile& motion, double error) {
        const auto table = compileIntervals(motion, machine, error, IntervalMode::Corrected);
        return table ? std::optional<Limit>() : table.error().limit;
    };
    MotionProfile there = move(LawId::Quintic, 100, 1);
    there.addDisplacement(1, -50, lawOf(LawId::Quintic), {});
    QCOMPARE(limit(there, 10), std::optional(Limit::Reversal));
    QCOMPARE(limit(move(LawId::Quintic, 0.001, 1), 10), std::optional(Limit::TooFewPulses));
    QCOMPARE(limit(move(LawId::Quintic, 600, 1), 0), std::optional(Limit::SpeedError));
    QCOMPARE(limit(move(LawId::Quintic, 600, 1), -1), std::optional(Limit::SpeedError));
    QCOMPARE(limit(move(LawId::Quintic, 600, 1), std::nan("")), std::optional(Limit::SpeedError));
    QCOMPARE(limit(move(LawId::Quintic, 60000, 1), 10), std::optional(Limit::PulseFrequency));
}

void TestIntervals::refusedErrorNamesOneThatIsKept_data()
{
    QTest::addColumn<MotionProfile>("motion");
    QTest::addColumn<double>("pulsesPerMm");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("largest");  // that may be named
    QTest::addColumn<bool>("isSmallest"); // of those that are kept
    for (const double error : {0.0, 0.004}) {
        QTest::addRow("quintic, %g mm/s", error)
            << move(LawId::Quintic, 600, 1) << 100.0 << error << 0.5 << false;
        QTest::addRow("cubic, %g mm/s", error)
            << move(LawId::Cubic, 30, 0.1) << 100.0 << error << 5.0 << false;
    }
    QTest::newRow("harmonic, few pulses") << move(LawId::Harmonic, 10, 0.1) << 10.0 << 0.02 << 1.0 << true;
    QTest::newRow("fast speed move") << ramp(LawId::Quintic, 0, 9000, 0.05) << 10.0 << 10.0 << 30.0 << false;
    QTest::newRow("moving ends") << ramp(LawId::Trapezoid, 225, 1384, 0.0324) << 1.9 << 2.0 << 8.0 << true;
    QTest::newRow("harmonic, published")
        << move(LawId::Harmonic, 40.871, 1.015) << 10.0 << 0.214 << 0.27 << true;
    test::Recipe cutter = test::checkRecipe();
    cutter.program.pinned = {Field::Rate, Field::FilmSpeed};
    cutter.program.rateBagsPerMin = 227.5;
    cutter.program.filmSpeedMmPerS = 385.6;
    cutter.program.k = {1.8914, 1.8079, 1.1843, 1.0683};
    cutter.program.speedLaw = LawId::Harmonic;
    cutter.machine.knifeRadiusMm = 97.14;
    cutter.machine.knives = 2;
    cutter.machine.maxKnifeAccelerationMmPerS2 = 1'000'000;
    const auto knife = solve(cutter.program, cutter.machine);
    QTest::newRow("cutter of few pulses")
        << knife->motion << 1250 / (2 * std::numbers::pi * 97.14) << 8.0 << 12.0 << true;
}

void TestIntervals::refusedErrorNamesOneThatIsKept()
{
    QFETCH(MotionProfile, motion);
    QFETCH(double, pulsesPerMm);
    QFETCH(double, error);
    QFETCH(double, largest);
    QFETCH(bool, isSmallest);
    const Machine machine = machineOf(pulsesPerMm);
    const auto mode = QByteArray(QTest::currentDataTag()).contains("published") ? IntervalMode::Published
                                                                                : IntervalMode::Corrected;
    const auto tight = compileIntervals(motion, machine, error, mode);
    QVERIFY(!tight && tight.error().limit == Limit::SpeedError);
    const std::string text = describe(tight.error());
    // The value as read by a person.
    const double allowed = std::stod(text.substr(text.find("allowed ") + 8));
    QVERIFY2(allowed > error && allowed <= largest, text.c_str());
    const auto table = compileIntervals(motion, machine, allowed, mode);
    QVERIFY2(table, text.c_str());
    QCOMPARE(broken(*table, allowed), QString());
    for (const double share : {0.98, 0.9, 0.7})
        QVERIFY2(!isSmallest || !compileIntervals(motion, machine, share * allowed, mode), text.c_str());
}

void TestIntervals::statedErrorsAreNotBelowTheTrueOnes_data()
{
    QTest::addColumn<MotionProfile>("motion");
    QTest::addColumn<double>("pulsesPerMm");
    QTest::addColumn<double>("error");
    const auto row = [](const char* tag, const MotionProfile& motion, double pulsesPerMm, double error) {
        QTest::newRow(tag) << motion << pulsesPerMm << error;
    };
    row("ends at a speed above rest", move(LawId::Parabolic, 12, 0.05), 200, 1);
    row("last pulse after the end", move(LawId::Harmonic, 10.013, 0.087), 10, 2.77376);
    row("joint inside a row", move(LawId::Trapezoid, 600, 1), 10, 60);
    row("corner of a parabola", move(LawId::Parabolic, 61.3, 0.21), 20, 40);
    row("many rows", move(LawId::ModifiedSine, 60, 0.3), 100, 0.8);
    row("goes on moving", ramp(LawId::Exponential, 0, 300, 0.2), 30, 6);
    row("comes from moving", ramp(LawId::Quintic, -400, 0, 0.2), 30, 3);
    row("three pulses", move(LawId::Cycloidal, 0.31, 0.04), 10, 14);
}

void TestIntervals::statedErrorsAreNotBelowTheTrueOnes()
{
    QFETCH(MotionProfile, motion);
    QFETCH(double, pulsesPerMm);
    QFETCH(double, error);
    for (const IntervalMode mode : {IntervalMode::Published, IntervalMode::Corrected}) {
        const auto table = compileIntervals(motion, machineOf(pulsesPerMm), error, mode);
        QVERIFY2(table, reason(table).c_str());
        QCOMPARE(broken(*table, error), QString());
        const IntervalErrors seen = replayed(*table, motion, pulsesPerMm, mode, 11);
        qInfo("%zu rows, stated %.6f mm/s, %.5f pulses; seen %.6f mm/s, %.5f pulses", table->rows.size(),
              table->errors.speedMmPerS, table->errors.positionPulses, seen.speedMmPerS, seen.positionPulses);
        QVERIFY(table->errors.speedMmPerS >= seen.speedMmPerS * (1 - 1e-9));
        QVERIFY(table->errors.positionPulses >= seen.positionPulses * (1 - 1e-9));
        QVERIFY(table->errors.speedMmPerS <= seen.speedMmPerS * 1.002 + 2 * stepMmPerS(*table, pulsesPerMm));
        QVERIFY(table->errors.positionPulses <= seen.positionPulses * 1.002 + 1e-3);
    }
}

void TestIntervals::rowsEndWithAStretch_data()
{
    QTest::addColumn<MotionProfile>("motion");
    QTest::addColumn<double>("error");
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("lines");
    QTest::newRow("up and level, down") << move(LawId::Trapezoid, 600, 1) << 5.0 << 2 << 3;
    QTest::newRow("closely") << move(LawId::Trapezoid, 600, 1) << 1.0 << 2 << 3;
    MotionProfile up;
    up.addCubic(0.2, 0, 1000, 0);
    up.addConstant(0.3, 200);
    QTest::newRow("up and level") << up << 2.0 << 1 << 2;
    MotionProfile down;
    down.addConstant(0.1, 200);
    down.addCubic(0.1, 200, -1000, 0);
    down.addConstant(0.2, 100);
    QTest::newRow("level, down and level") << down << 2.0 << 2 << 3;
}

// A ramp and the stretch at its last speed are one row.
void TestIntervals::rowsEndWithAStretch()
{
    QFETCH(MotionProfile, motion);
    QFETCH(double, error);
    QFETCH(int, rows);
    QFETCH(int, lines);
    const auto table = compileIntervals(motion, machineOf(10), error, IntervalMode::Corrected);
    QVERIFY2(table, reason(table).c_str());
    QCOMPARE(broken(*table, error), QString());
    QCOMPARE(static_cast<int>(table->rows.size()), rows);
    QCOMPARE(table->minLinks, lines);
}

// Between two speeds with a constant jerk j: with c = sqrt(8 e / j) the first and the last line, which begin
// or end on the curve, last (1 + sqrt 2) c / 2, each other one sqrt(2) c.
void TestIntervals::fewestLinesKeepTheWholeError()
{
    constexpr double jerk = 3000;
    constexpr int lines = 7;
    MotionProfile motion;
    motion.addCubic(1, 100, 0, jerk);
    const double c = 1 / (1 + std::numbers::sqrt2 * (lines - 1));
    const double error = jerk * c * c / 8;
    const auto fewest = [&](double mmPerS) {
        const auto table = compileIntervals(motion, Machine{}, mmPerS, IntervalMode::Corrected);
        return table ? table->minLinks : 0;
    };
    QCOMPARE(fewest(1.004 * error), lines);
    QCOMPARE(fewest(0.996 * error), lines + 1);
}

void TestIntervals::largerErrorsNeedNoMoreRows_data()
{
    QTest::addColumn<MotionProfile>("motion");
    QTest::addColumn<double>("pulsesPerMm");
    QTest::addColumn<double>("smallest");
    QTest::newRow("parabolic speed move") << ramp(LawId::Parabolic, 0, 1000, 0.02) << 10.0 << 60.0;
    QTest::newRow("quintic speed move") << ramp(LawId::Quintic, 0, 9000, 0.05) << 10.0 << 12.0;
    QTest::newRow("move") << move(LawId::ModifiedSine, 30, 0.2) << 30.0 << 1.0;
    QTest::newRow("published in small numbers") << move(LawId::Cubic, 20, 0.5) << 4.0 << 0.5;
    MotionProfile few;
    few.addRamp(0.0587, -3.516, 0, lawOf(LawId::HalfModifiedSine), {}, true);
    QTest::newRow("ten pulses") << few << 83.8 << 0.1;
    const test::Recipe recipe = test::checkRecipe();
    const auto knife = solve(recipe.program, recipe.machine);
    QTest::newRow("cutter") << knife->motion << 20.0 << 0.4;
}

void TestIntervals::largerErrorsNeedNoMoreRows()
{
    QFETCH(MotionProfile, motion);
    QFETCH(double, pulsesPerMm);
    QFETCH(double, smallest);
    constexpr double factor = 1.09;
    constexpr double range = 40;
    for (const IntervalMode mode : {IntervalMode::Published, IntervalMode::Corrected}) {
        std::size_t rows = intervalCapacity;
        bool wasKept = false;
        for (double error = smallest; error < range * smallest; error *= factor) {
            const auto table = compileIntervals(motion, machineOf(pulsesPerMm), error, mode);
            QVERIFY2(table || !wasKept, qPrintable(QStringLiteral("%1 mm/s").arg(error)));
            if (!table)
                continue;
            wasKept = true;
            QCOMPARE(broken(*table, error), QString());
            QVERIFY2(table->rows.size() <= rows, qPrintable(QStringLiteral("%1 mm/s").arg(error)));
            rows = table->rows.size();
        }
        QVERIFY(wasKept);
    }
}

void TestIntervals::randomMoves()
{
    constexpr unsigned seed = 31;
    constexpr int replayedEvery = 20; // iteration by iteration is slow
    const int cases = campanel::test::randomCases(2000);
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int refused = 0;
    int fewest = 0; // tables with the minimum number of rows
    double steepest = 0;
    double rows = 0;
    double links = 0;
    for (int i = 0; i < cases; ++i) {
        const Law& law = campanel::profile::laws()[random() % campanel::profile::laws().size()];
        LawParameters parameters{};
        for (std::size_t p = 0; p < law.parameters.size(); ++p)
            parameters[p] = law.parameters[p].defaultValue;
        const double sign = random() % 2 == 0 ? 1 : -1;
        const double duration = uniform(0.05, 0.5);
        const double distance = sign * uniform(5, 500) * duration;
        MotionProfile motion;
        if (law.isDisplacementLaw)
            motion.addDisplacement(duration, distance, law, parameters);
        else
            motion.addRamp(duration, 0, distance / duration, law, parameters, false);
        const double error = uniform(0.08, 0.4) * std::abs(distance) / duration;
        const auto mode = static_cast<IntervalMode>(random() % 2);
        const auto table = compileIntervals(motion, Machine{}, error, mode);
        if (!table) {
            QVERIFY2(table.error().limit == Limit::SpeedError, describe(table.error()).c_str());
            ++refused;
            continue;
        }
        const QString complaint = broken(*table, error);
        QVERIFY2(complaint.isEmpty(), qPrintable(QStringLiteral("case %1, %2: %3 (allowed %4)")
                                                     .arg(i)
                                                     .arg(QString::fromUtf8(law.key.data()))
                                                     .arg(complaint)
                                                     .arg(error)));
        const double pulses = std::abs(motion.at(duration).positionMm) * 100;
        QVERIFY(std::abs(static_cast<double>(std::abs(table->advance)) - pulses) <= 0.5 + 1e-6);
        QVERIFY((table->advance > 0) == (sign > 0));
        const auto count = static_cast<int>(table->rows.size());
        steepest = std::max(steepest, steepness(*table, motion));
        // A row covers at most two lines.
        QVERIFY(table->minLinks >= 1 && table->minLinks <= 2 * count);
        fewest += count <= table->minLinks ? 1 : 0;
        if (i % replayedEvery == 0) {
            const IntervalErrors seen = replayed(*table, motion, 100, mode, 997);
            QVERIFY(table->errors.speedMmPerS >= seen.speedMmPerS * (1 - 1e-9));
            QVERIFY(table->errors.positionPulses >= seen.positionPulses * (1 - 1e-9));
            QVERIFY(table->errors.speedMmPerS <= 1.05 * seen.speedMmPerS + 2 * stepMmPerS(*table, 100));
            const auto coarser = compileIntervals(motion, Machine{}, 1.3 * error, mode);
            QVERIFY(coarser && coarser->rows.size() <= table->rows.size());
        }
        rows += count;
        links += table->minLinks;
    }
    qInfo("%d of %d refused; %d with as few rows as lines, all together %.3f times as many", refused, cases,
          fewest, rows / links);
    qInfo("steepest row %.2f times as steep as its motion", steepest);
    QVERIFY(rows < 1.1 * links);
    QVERIFY(steepest < 1.5);
    QVERIFY(refused * 50 < cases);
}

CAMPANEL_TEST(TestIntervals)

} // namespace test_intervals

#include "test_intervals.moc"
