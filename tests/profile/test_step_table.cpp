// SPDX-License-Identifier: Apache-2.0
// The step table: exact sums, timer range, distance from the curve by replay, difficult machines, refusals.
#include "recipes.h"
#include "table_replay.h"

#include "profile/cutter/limits.h"
#include "profile/laws/laws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_step_table {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

StepTable built(const Recipe& recipe)
{
    const auto cutter = solve(recipe.program, recipe.machine);
    const auto table = cutter ? buildStepTable(*cutter) : tl::unexpected(cutter.error());
    if (!table)
        qFatal("%s", describe(table.error()).c_str());
    return *table;
}

} // namespace

class TestStepTable : public QObject {
    Q_OBJECT

private slots:
    void rowsOfOneSliceAreNoBoundaries();
    void pulsesAreExactForEverySliceCount();
    void noDriftInAMillionCycles_data();
    void noDriftInAMillionCycles();
    void fractionStaysInTheCarryRow();
    void replayStaysAtTheCurve_data();
    void replayStaysAtTheCurve();
    void statedErrorsAreTheRealOnes_data();
    void statedErrorsAreTheRealOnes();
    void moreSlicesAreNeverMuchWorse();
    void slowPulsesArePausedFor();
    void longRowsAreSplit();
    void atTheHighestFrequency();
    void refusesMoreRowsThanTheControllerHolds();
    void refusesAFrequencyBeyondTheTimer();
    void refusesLessThanAPulse();
};

// The figure: L = 250, rate 60, R = 60, K = 10000, Z = 1, k as written with four decimals.
// Found by the million random recipes: a ramp of 97,718 pulses in one slice needs two rows, and in its middle
// the slice is 25,331 pulses from the curve.
void TestStepTable::rowsOfOneSliceAreNoBoundaries()
{
    Recipe r;
    r.program.pinned = {Field::BagLength, Field::Rate};
    r.program.bagLengthMm = 25;
    r.program.rateBagsPerMin = 22.5;
    r.program.k = {6.0517, 3.6926, 2.1649, 1.0412};
    r.program.speedLaw = LawId::SCurve;
    r.program.speedLawParameters = {0.0702972, 0.0625429};
    r.program.slicesPerRamp = 1;
    r.program.syncRatio = 0.934;
    r.machine.knifeRadiusMm = 126.34;
    r.machine.pulsesPerMotorRev = 10454;
    r.machine.gearNumerator = 19;
    r.machine.gearDenominator = 1;
    r.machine.knives = 1;
    r.machine.maxMotorRpm = 20'000;
    r.machine.maxKnifeAccelerationMmPerS2 = 100'000;
    const StepTable table = built(r);
    QVERIFY(sumOfPulses(table) > 2 * 65'535);
    QVERIFY(table.errors.insidePulses > 20'000);
    QVERIFY2(table.errors.boundaryPulses <= 1.5, std::to_string(table.errors.boundaryPulses).c_str());
}

void TestStepTable::pulsesAreExactForEverySliceCount()
{
    for (int slices = 1; slices <= 1000; slices += (slices < 70 ? 1 : 31)) {
        Recipe r = checkRecipe();
        r.program.k = {4, 2.5, 1.6667, 1.3333};
        r.program.slicesPerRamp = slices;
        const StepTable table = built(r);
        QCOMPARE(sumOfPulses(table), std::int64_t{10000});
        QCOMPARE(table.pulses.whole, std::int64_t{10000});
        QCOMPARE(table.pulses.remainder, std::int64_t{0});
        QCOMPARE(sumOfTicks(table), std::int64_t{8000000});
        QCOMPARE(table.cycleTicks, 8000000U);
        QVERIFY(table.rows.size() <= static_cast<std::size_t>(2 * slices + 3));
        for (const StepRow& row : table.rows)
            QVERIFY(isWithinTimer(row, r.machine));
    }
}

void TestStepTable::noDriftInAMillionCycles_data()
{
    QTest::addColumn<int>("pulsesPerRev");
    QTest::addColumn<int>("knives");
    QTest::addColumn<int>("gearNumerator");
    QTest::addColumn<int>("gearDenominator");
    QTest::newRow("K=10000 N=1") << 10000 << 1 << 1 << 1;
    QTest::newRow("K=10007 N=3") << 10007 << 3 << 1 << 1;
    QTest::newRow("K=10000 N=7 Z=11/13") << 10000 << 7 << 11 << 13;
    QTest::newRow("K=131072 N=3 Z=22/7") << 131072 << 3 << 22 << 7;
}

void TestStepTable::noDriftInAMillionCycles()
{
    QFETCH(int, pulsesPerRev);
    QFETCH(int, knives);
    QFETCH(int, gearNumerator);
    QFETCH(int, gearDenominator);
    Recipe r = checkRecipe(60);
    r.machine.pulsesPerMotorRev = pulsesPerRev;
    r.machine.knives = knives;
    r.machine.gearNumerator = gearNumerator;
    r.machine.gearDenominator = gearDenominator;
    r.machine.maxPulseFrequencyHz = 500000;
    const StepTable table = built(r);
    QVERIFY(isWithinTimer(table.rows[table.carryRow], r.machine));
    if (table.pulses.remainder > 0)
        QVERIFY(isWithinTimer(table.rows[table.carryRow], r.machine, 1));
    constexpr std::int64_t cycles = 1000000;
    std::int64_t accumulated = 0;
    std::int64_t total = 0;
    const std::int64_t perCycle = sumOfPulses(table);
    for (std::int64_t i = 0; i < cycles; ++i) {
        accumulated += table.pulses.remainder;
        total += perCycle;
        if (accumulated >= table.pulses.divisor) {
            accumulated -= table.pulses.divisor;
            ++total;
        }
    }
    const std::int64_t numerator = std::int64_t{pulsesPerRev} * gearNumerator * cycles;
    QCOMPARE(total, numerator / (std::int64_t{gearDenominator} * knives));
}

// 10007 / 3 = 3335 + 2/3: the missing two thirds of a pulse slow only the carry row, every other row follows
// the curve.
void TestStepTable::fractionStaysInTheCarryRow()
{
    Recipe r = checkRecipe(60);
    r.machine.pulsesPerMotorRev = 10007;
    r.machine.knives = 3;
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const auto table = buildStepTable(*cutter);
    QVERIFY(table.has_value());
    const double clock = r.machine.timerClockHz;
    double start = 0;
    for (std::size_t i = 0; i < table->rows.size(); ++i) {
        const StepRow& row = table->rows[i];
        const double end = start + row.ticks / clock;
        const double travel = (cutter->motion.at(end).positionMm - cutter->motion.at(start).positionMm) *
                              pulsesPerMm(r.machine);
        const double missing = i == table->carryRow ? 2.0 / 3 : 0;
        QVERIFY2(std::abs(travel - row.pulses - missing) < 0.02, std::to_string(i).c_str());
        start = end;
    }
}

void TestStepTable::replayStaysAtTheCurve_data()
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < laws().size(); ++i)
        QTest::newRow(std::string(laws()[i].key).c_str()) << static_cast<int>(i);
}

// At every pulse the count and the curve's travel agree within the stated error and the pulse itself.
void TestStepTable::replayStaysAtTheCurve()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    Recipe r = checkRecipe(120, 90);
    r.program.speedLaw = law.id;
    r.program.speedLawParameters = defaultParameters(law);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const auto table = buildStepTable(*cutter);
    QVERIFY(table.has_value());
    QVERIFY(table->errors.boundaryPulses <= 0.01); // half a tick at 21 kHz is 0.0013 pulses
    QVERIFY(table->errors.insidePulses <= 0.2);
    const double perMm = pulsesPerMm(r.machine);
    std::int64_t count = 0;
    std::int64_t previous = 0;
    double worst = 0;
    replay(*table, [&](std::int64_t tick) {
        ++count;
        const double travel =
            cutter->motion.at(static_cast<double>(tick) / r.machine.timerClockHz).positionMm * perMm;
        worst = std::max(worst, std::abs(static_cast<double>(count) - travel));
        QVERIFY(tick - previous >= minTimerConstant(r.machine));
        previous = tick;
    });
    QVERIFY2(worst <= table->errors.insidePulses + 0.01, std::to_string(worst).c_str());
    QCOMPARE(previous, std::int64_t{table->cycleTicks});
}

void TestStepTable::statedErrorsAreTheRealOnes_data()
{
    QTest::addColumn<int>("slices");
    QTest::addColumn<int>("pulsesPerRev");
    QTest::addColumn<int>("knives");
    QTest::addColumn<int>("law");
    QTest::addColumn<double>("parameter");
    const auto row = [](const char* name, int slices, int pulsesPerRev, int knives, LawId law = LawId::Cubic,
                        double parameter = 0) {
        QTest::newRow(name) << slices << pulsesPerRev << knives << static_cast<int>(law) << parameter;
    };
    row("20 slices", 20, 10000, 1);
    row("60 slices, fraction of a pulse per cycle", 60, 10007, 3);
    row("3 slices", 3, 10000, 1);
    row("slices shorter than a pulse", 400, 1000, 1);
    row("steep exponential, 1 slice", 1, 10000, 1, LawId::Exponential, 10);
    row("steepest exponential, 3 slices", 3, 10000, 1, LawId::Exponential, 20);
    row("4-5-6-7, 2 slices", 2, 10000, 1, LawId::Polynomial4567);
    row("short ramps, 1 slice", 1, 10000, 1, LawId::Trapezoid, 0.01);
    row("half a modified sine, 1 slice", 1, 10000, 1, LawId::HalfModifiedSine);
    row("rows that are split", 2, 1280003, 3, LawId::Parabolic);
}

// Replays the rows at many places of each: no error is larger than stated, nor overstated.
void TestStepTable::statedErrorsAreTheRealOnes()
{
    QFETCH(int, slices);
    QFETCH(int, pulsesPerRev);
    QFETCH(int, knives);
    QFETCH(int, law);
    QFETCH(double, parameter);
    Recipe r = checkRecipe(100);
    r.program.slicesPerRamp = slices;
    r.program.speedLaw = static_cast<LawId>(law);
    r.program.speedLawParameters = {parameter, 0};
    r.machine.pulsesPerMotorRev = pulsesPerRev;
    r.machine.knives = knives;
    r.machine.maxPulseFrequencyHz = 2000000;
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const auto built = buildStepTable(*cutter);
    QVERIFY(built.has_value());
    const double perMm = pulsesPerMm(r.machine);
    const double clock = r.machine.timerClockHz;
    double speed = 0;
    double inside = 0;
    double step = 0;
    double squares = 0;
    double start = 0;
    double count = 0;
    const auto hz = [&r](const StepRow& row) { return frequencyHz(row, r.machine); };
    double previousHz = hz(built->rows.back());
    for (const StepRow& row : built->rows) {
        step = std::max(step, std::abs(hz(row) - previousHz));
        previousHz = hz(row);
        const int parts = slices <= 3 ? 40000 : 400;
        for (int i = 0; i <= parts; ++i) {
            const double elapsed = row.ticks / clock * i / parts;
            const MotionPoint p = cutter->motion.at(start + elapsed);
            const double ahead = count + hz(row) * elapsed - p.positionMm * perMm;
            speed = std::max(speed, std::abs(hz(row) / perMm - p.velocityMmPerS));
            inside = std::max(inside, std::abs(ahead));
            const int weight = i == 0 || i == parts ? 1 : 2 + 2 * (i % 2); // for Simpson's rule
            squares += ahead * ahead * row.ticks / clock / parts * weight / 3;
        }
        start += row.ticks / clock;
        count += row.pulses;
    }
    const TableErrors& stated = built->errors;
    // The tolerance for maxima between the sampled places, and rounding.
    const auto agrees = [](double a, double b, double most) {
        return a >= b * (1 - 1e-6) - 1e-8 && a <= b * most + 1e-8;
    };
    const double rms = std::sqrt(squares / cutter->cycle.cycleTimeS);
    QVERIFY2(agrees(stated.speedMmPerS, speed, 1.001), std::to_string(speed).c_str());
    QVERIFY2(agrees(stated.frequencyStepHz, step, 1.001), std::to_string(step).c_str());
    QVERIFY2(agrees(stated.insidePulses, inside, 1.001), std::to_string(inside).c_str());
    QVERIFY2(agrees(stated.rmsPulses, rms, 1.0001), std::to_string(rms).c_str());
    QVERIFY(agrees(stated.speedPercent, 100 * speed / peaks(*cutter).speedMmPerS, 1.001));
}

void TestStepTable::moreSlicesAreNeverMuchWorse()
{
    Recipe r = checkRecipe();
    double previous = 1e9;
    for (const int slices : {1, 2, 4, 8, 16, 32, 64, 128}) {
        r.program.slicesPerRamp = slices;
        const double now = built(r).errors.speedMmPerS;
        QVERIFY2(now < 0.7 * previous, std::to_string(now).c_str());
        previous = now;
    }
}

void TestStepTable::slowPulsesArePausedFor()
{
    Recipe r = checkRecipe();
    r.program.pinned = {Field::BaseSpeed, Field::Rate};
    r.program.baseSpeedMmPerS = 0; // the knife rests between cuts
    r.program.rateBagsPerMin = 5;
    r.machine.pulsesPerMotorRev = 600;
    const StepTable table = built(r);
    QCOMPARE(sumOfPulses(table), std::int64_t{600});
    QCOMPARE(sumOfTicks(table), std::int64_t{96000000});
    QCOMPARE(table.rows.front().pulses, std::uint16_t{0});
    QVERIFY(table.rows.front().ticks >= 24000000U); // all of AB in one row
    int pauses = 0;
    for (const StepRow& row : table.rows) {
        QVERIFY(isWithinTimer(row, r.machine));
        pauses += row.pulses == 0 ? 1 : 0;
    }
    QVERIFY(pauses > 2); // also between the slow pulses of the ramps
}

void TestStepTable::longRowsAreSplit()
{
    Recipe r = checkRecipe(250, 5);
    r.machine.pulsesPerMotorRev = 1280003;
    r.machine.maxPulseFrequencyHz = 500000;
    const StepTable table = built(r);
    QCOMPARE(sumOfPulses(table), std::int64_t{1280003});
    QCOMPARE(sumOfTicks(table), std::int64_t{96000000});
    QVERIFY(table.rows.size() > 2 * 60 + 3 + 6); // AB, BC and DA take several rows each
    for (const StepRow& row : table.rows)
        QVERIFY(isWithinTimer(row, r.machine));
    QVERIFY(isWithinTimer(table.rows[table.carryRow], r.machine, 1));
}

// The base speed exactly at the timer's limit: a table within the range, or a refusal that helps.
void TestStepTable::atTheHighestFrequency()
{
    int tables = 0;
    int refused = 0;
    for (int i = 0; i <= 200; ++i) {
        Recipe r = checkRecipe();
        r.machine.knives = 3;
        r.machine.pulsesPerMotorRev = 120000 + i;
        r.program.pinned = {Field::BaseSpeed, Field::FilmSpeed};
        r.program.baseSpeedMmPerS = 200000 / pulsesPerMm(r.machine);
        r.program.filmSpeedMmPerS = r.program.baseSpeedMmPerS * (0.5 + 0.0025 * i); // at last the whole cycle
        const auto cutter = solve(r.program, r.machine);
        QVERIFY(cutter.has_value());
        QVERIFY(checkLimits(*cutter).empty());
        const auto table = buildStepTable(*cutter);
        if (table) {
            ++tables;
            QCOMPARE(sumOfPulses(*table), table->pulses.whole);
            for (const StepRow& row : table->rows)
                QVERIFY(isWithinTimer(row, r.machine));
            if (table->pulses.remainder > 0)
                QVERIFY(isWithinTimer(table->rows.at(table->carryRow), r.machine, 1));
            continue;
        }
        ++refused;
        QCOMPARE(static_cast<int>(table.error().limit), static_cast<int>(Limit::PulseFrequency));
        QVERIFY(table.error().actual > table.error().allowed);
        QVERIFY(!table.error().nearest.empty());
        for (const Suggestion& s : table.error().nearest) {
            Recipe mended = r;
            setValue(mended.program, s.field, s.value);
            QCOMPARE(sumOfPulses(built(mended)), pulsesPerCycle(mended.machine).whole);
        }
    }
    QVERIFY2(tables > 100 && refused > 0, std::to_string(refused).c_str());
}

void TestStepTable::refusesMoreRowsThanTheControllerHolds()
{
    Recipe r = checkRecipe();
    r.program.slicesPerRamp = 1000;
    r.machine.rowCapacity = 100;
    const auto table = buildStepTable(*solve(r.program, r.machine));
    QVERIFY(!table.has_value());
    QCOMPARE(static_cast<int>(table.error().limit), static_cast<int>(Limit::RowCapacity));
    QCOMPARE(table.error().allowed, 100.0);
    QVERIFY(table.error().actual > 1000);
    const Suggestion& best = table.error().nearest.at(0);
    QCOMPARE(static_cast<int>(best.field), static_cast<int>(Field::SlicesPerRamp));
    r.program.slicesPerRamp = static_cast<int>(best.value);
    QVERIFY(built(r).rows.size() <= 100);
    ++r.program.slicesPerRamp;
    QVERIFY(!buildStepTable(*solve(r.program, r.machine)).has_value());
}

void TestStepTable::refusesAFrequencyBeyondTheTimer()
{
    Recipe r = checkRecipe(250, 240);
    r.machine.maxPulseFrequencyHz = 40000;
    const auto table = buildStepTable(*solve(r.program, r.machine));
    QVERIFY(!table.has_value());
    QCOMPARE(static_cast<int>(table.error().limit), static_cast<int>(Limit::PulseFrequency));
    QVERIFY(std::abs(table.error().actual - 4 * 11813.83) < 0.1);
    QCOMPARE(table.error().allowed, 40000.0);
    QVERIFY(!table.error().nearest.empty());
}

void TestStepTable::refusesLessThanAPulse()
{
    Recipe r = checkRecipe();
    r.machine.pulsesPerMotorRev = 2;
    r.machine.knives = 3;
    r.program.bagLengthMm = 60;
    const auto table = buildStepTable(*solve(r.program, r.machine));
    QVERIFY(!table.has_value());
    QCOMPARE(static_cast<int>(table.error().limit), static_cast<int>(Limit::TooFewPulses));
    QCOMPARE(static_cast<int>(table.error().nearest.at(0).field), static_cast<int>(Field::PulsesPerMotorRev));
    QCOMPARE(table.error().nearest.at(0).value, 3.0);
}

CAMPANEL_TEST(TestStepTable)

} // namespace test_step_table

#include "test_step_table.moc"
