// SPDX-License-Identifier: Apache-2.0
// The press program: stages and times of the nominal stroke by hand, the ranges of the servo-press paper, the
// order of positions and forces, the limits of the machine, the table.
#include "profile/press/press.h"
#include "random_cases.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_press {

using namespace campanel::profile;

namespace {

bool isNear(double actual, double expected, double tolerance = 1e-9)
{
    return std::abs(actual - expected) <= tolerance;
}

void putInOrder(PressProgram& program)
{
    std::array positions{program.approachPositionMm, program.probeEndMm, program.pressPositionMm};
    std::ranges::sort(positions);
    std::array forces{program.minStopForceN, program.probeForceN, program.maxStopForceN, program.maxForceN};
    std::ranges::sort(forces);
    program.approachPositionMm = positions[0];
    program.probeEndMm = positions[1];
    program.pressPositionMm = positions[2];
    program.minStopForceN = forces[0];
    program.probeForceN = forces[1];
    program.maxStopForceN = forces[2];
    program.maxForceN = forces[3];
}

} // namespace

class TestPress : public QObject {
    Q_OBJECT

private slots:
    void strokeOfTheDefaults();
    void strokeIsContinuous();
    void shortStagesStayBelowTheirSpeed();
    void rangesOfThePaper_data();
    void rangesOfThePaper();
    void wrongOrders_data();
    void wrongOrders();
    void brokenLimitsNameTheSpeed();
    void torqueIsNoLimit();
    void suggestsTheNearestSpeed_data();
    void suggestsTheNearestSpeed();
    void tableOfTheDefaults();
    void tableStatesItsRounding();
    void tableRefusesWhatItCannotHold();
    void randomProgramsEndWhereTheyShould();
    void randomSuggestionsWork();

private:
    static void verifySuggestions(const PressProgram& program, const Machine& machine,
                                  const std::vector<Suggestion>& suggestions);
    static void verifyNearestSpeed(const PressProgram& program, const Machine& machine,
                                   const std::vector<Suggestion>& suggestions);
};

// 0.01 mm per pulse, 50 m/s^2: ramps of 2, 1, 1 and 2 ms. A stage takes its distance over its speed plus a
// ramp.
void TestPress::strokeOfTheDefaults()
{
    const auto stroke = solveStroke(PressProgram{}, Machine{});
    QVERIFY(stroke.has_value());
    QVERIFY(stroke->motion.broken.empty());
    const double ends[] = {60.0 / 80 + 0.002 + 0.02, 15.0 / 4 + 0.001 + 0.02, 25.0 / 10 + 0.001, 0.5,
                           100.0 / 80 + 0.002};
    const double positions[] = {60, 75, 100, 100, 0};
    double timeS = 0;
    double fromMm = 0;
    for (std::size_t i = 0; i < pressStages; ++i) {
        const StageSpan& stage = stroke->stages[i];
        QVERIFY(isNear(stage.fromS, timeS));
        timeS += ends[i];
        QVERIFY(isNear(stage.toS, timeS));
        QVERIFY(isNear(stage.fromMm, fromMm));
        QVERIFY(isNear(stage.toMm, positions[i]));
        QVERIFY(isNear(stroke->motion.motion.at(stage.toS).positionMm, positions[i]));
        QVERIFY(isNear(stroke->motion.motion.at(stage.toS).velocityMmPerS, 0));
        if (i < 4)
            QVERIFY(isNear(stroke->motion.marksS.at(i), timeS));
        fromMm = positions[i];
    }
    QCOMPARE(stroke->motion.marksS.size(), std::size_t{4});
    QVERIFY(isNear(stroke->motion.motion.durationS(), 8.796));
    QVERIFY(isNear(stroke->motion.peaks.speedMmPerS, 80));
    QVERIFY(isNear(stroke->motion.peaks.motorRpm, 48));
    QVERIFY(isNear(stroke->motion.peaks.pulseFrequencyHz, 8000, 1e-6));
    QVERIFY(isNear(stroke->motion.peaks.accelerationMmPerS2, 40'000, 1e-6));
    QVERIFY(isNear(stroke->motion.motion.at(0.4).velocityMmPerS, 80));
    QVERIFY(isNear(stroke->motion.motion.at(2).velocityMmPerS, 4));
    QVERIFY(isNear(stroke->motion.motion.at(6).velocityMmPerS, 10));
    QVERIFY(isNear(stroke->motion.motion.at(8).velocityMmPerS, -80));
    const auto motion = solve(PressProgram{}, Machine{});
    QVERIFY(motion.has_value());
    QCOMPARE(motion->motion.durationS(), stroke->motion.motion.durationS());
}

void TestPress::strokeIsContinuous()
{
    const auto stroke = solveStroke(PressProgram{}, Machine{});
    const auto segments = stroke->motion.motion.segments();
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        const MotionPoint end = segments[i].at(segments[i].endS());
        const MotionPoint begin = segments[i + 1].at(segments[i + 1].startS);
        QVERIFY(isNear(end.positionMm, begin.positionMm, 1e-12 * 100));
        QVERIFY(isNear(end.velocityMmPerS, begin.velocityMmPerS, 1e-12 * 100));
    }
}

// On half the distance the speed is sqrt(a s) after sqrt(s / a).
void TestPress::shortStagesStayBelowTheirSpeed()
{
    PressProgram program;
    program.approachPositionMm = 0.5;
    Machine machine;
    machine.maxAccelerationMmPerS2 = 1000; // 80 ms to 80 mm/s, which takes 3.2 mm
    const auto stroke = solveStroke(program, machine);
    QVERIFY(stroke.has_value());
    const double halfS = std::sqrt(0.5 / 1000);
    QVERIFY(isNear(stroke->stages[0].toS, 2 * halfS + 0.02));
    QVERIFY(isNear(stroke->motion.motion.at(halfS).velocityMmPerS, std::sqrt(0.5 * 1000)));

    program.approachPositionMm = 0; // no approach at all
    const auto none = solveStroke(program, machine);
    QVERIFY(none.has_value());
    QVERIFY(isNear(none->stages[0].toS, 0.02));
}

void TestPress::rangesOfThePaper_data()
{
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::newRow("approach") << static_cast<int>(Field::ApproachSpeed) << 40.0 << 100.0;
    QTest::newRow("probe") << static_cast<int>(Field::ProbeSpeed) << 2.0 << 5.0;
    QTest::newRow("press") << static_cast<int>(Field::PressSpeed) << 5.0 << 15.0;
}

void TestPress::rangesOfThePaper()
{
    QFETCH(int, field);
    QFETCH(double, least);
    QFETCH(double, most);
    const auto at = [field](double speed) {
        PressProgram program;
        setValue(program, static_cast<Field>(field), speed);
        return solve(program, Machine{});
    };
    QVERIFY(at(least).has_value());
    QVERIFY(at(most).has_value());
    for (const double speed : {least - 0.1, most + 0.1}) {
        const auto refused = at(speed);
        QVERIFY(!refused.has_value());
        QCOMPARE(static_cast<int>(refused.error().limit), static_cast<int>(Limit::FieldRange));
        QCOMPARE(static_cast<int>(refused.error().field), field);
        QCOMPARE(refused.error().allowed, speed < least ? least : most);
    }
    QVERIFY(!at(std::nan("")).has_value());
}

void TestPress::wrongOrders_data()
{
    QTest::addColumn<int>("changed");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("allowed");
    const auto row = [](const char* name, Field changed, double value, Limit limit, Field field,
                        double allowed) {
        QTest::newRow(name) << static_cast<int>(changed) << value << static_cast<int>(limit)
                            << static_cast<int>(field) << allowed;
    };
    row("probe ends where the approach does", Field::ProbeEnd, 60, Limit::StageOrder, Field::ProbeEnd, 60);
    row("approach beyond the probe", Field::ApproachPosition, 91, Limit::StageOrder, Field::ProbeEnd, 91);
    row("press no farther than the probe", Field::PressPosition, 90, Limit::StageOrder, Field::PressPosition,
        90);
    row("felt only at the limit", Field::ProbeForce, 8000, Limit::ForceOrder, Field::ProbeForce, 7999);
    row("window above the limit", Field::MaxStopForce, 8001, Limit::ForceOrder, Field::MaxStopForce, 8000);
    row("window upside down", Field::MinStopForce, 6001, Limit::ForceOrder, Field::MinStopForce, 6000);
}

void TestPress::wrongOrders()
{
    QFETCH(int, changed);
    QFETCH(double, value);
    QFETCH(int, limit);
    QFETCH(int, field);
    QFETCH(double, allowed);
    PressProgram program;
    setValue(program, static_cast<Field>(changed), value);
    const auto refused = solve(program, Machine{});
    QVERIFY(!refused.has_value());
    QCOMPARE(static_cast<int>(refused.error().limit), limit);
    QCOMPARE(static_cast<int>(refused.error().field), field);
    QCOMPARE(refused.error().allowed, allowed);
    for (const Suggestion& suggestion : refused.error().nearest) {
        setValue(program, suggestion.field, suggestion.value);
        QVERIFY(solve(program, Machine{}).has_value());
    }
    PressProgram weak; // below the probe's force and the window: both report the limit
    weak.maxForceN = 100;
    const auto force = solve(weak, Machine{}).error().nearest;
    QCOMPARE(force.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(force[0].field), static_cast<int>(Field::MaxForce));
    QCOMPARE(force[0].value, 6000.0);
    // Just within every order.
    PressProgram close;
    close.probeEndMm = 60.01;
    close.pressPositionMm = 60.02;
    close.probeForceN = 7999;
    close.maxStopForceN = 8000;
    close.minStopForceN = 8000;
    QVERIFY(buildPressTable(close, Machine{}).has_value());
}

// 48 r/min at 80 mm/s with 100 mm per revolution.
void TestPress::brokenLimitsNameTheSpeed()
{
    Machine machine;
    machine.maxMotorRpm = 45;
    PressProgram program;
    program.returnSpeedMmPerS = 70;
    const auto one = solve(program, machine);
    QVERIFY(one.has_value());
    QCOMPARE(one->broken.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(one->broken[0].limit), static_cast<int>(Limit::MotorSpeed));
    QCOMPARE(one->broken[0].nearest.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(one->broken[0].nearest[0].field), static_cast<int>(Field::ApproachSpeed));
    QVERIFY(isNear(one->broken[0].nearest[0].value, 75));
    program.approachSpeedMmPerS = 75;
    QVERIFY(solve(program, machine)->broken.empty());

    const auto two = solve(PressProgram{}, machine);
    QCOMPARE(two->broken.size(), std::size_t{1});
    QVERIFY(two->broken[0].nearest.empty());
}

// A recipe of a press has none of these three.
void TestPress::torqueIsNoLimit()
{
    Machine machine;
    machine.maxAccelerationMmPerS2 = 2000;
    const auto before = solve(PressProgram{}, machine);
    machine.maxTorqueNm = 0.001;
    machine.inertiaKgCm2 = 1000;
    machine.frictionNm = 1;
    const auto after = solve(PressProgram{}, machine);
    QVERIFY(after.has_value());
    QVERIFY(after->broken.empty());
    QVERIFY(std::isnan(after->peaks.torqueNm));
    QCOMPARE(after->motion.durationS(), before->motion.durationS());
    QCOMPARE(after->peaks.accelerationMmPerS2, 2000.0);
}

void TestPress::suggestsTheNearestSpeed_data()
{
    QTest::addColumn<double>("feed");
    QTest::addColumn<double>("rpm");
    QTest::addColumn<double>("acceleration");
    QTest::addColumn<double>("approachMm");
    QTest::addColumn<double>("approachSpeed");
    QTest::addColumn<double>("returnSpeed");
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("speed");
    const int back = static_cast<int>(Field::ReturnSpeed);
    QTest::newRow("603 r/min of 6 mm are 60.3 mm/s")
        << 6.0 << 603.0 << 2000.0 << 60.0 << 40.0 << 100.0 << back << 60.3;
    QTest::newRow("the approach is too short for its speed")
        << 8.191 << 600.0 << 2000.0 << 0.86 << 99.0 << 83.8 << back << 81.9;
    QTest::newRow("70 mm/s in 1000 ms") << 10.0 << 3000.0 << 70.0 << 60.0 << 70.0 << 80.0 << back << 70.0;
    QTest::newRow("two are too fast") << 6.0 << 603.0 << 2000.0 << 60.0 << 80.0 << 80.0 << -1 << 0.0;
    QTest::newRow("two ramps are too long") << 10.0 << 3000.0 << 70.0 << 60.0 << 80.0 << 80.0 << -1 << 0.0;
}

void TestPress::suggestsTheNearestSpeed()
{
    QFETCH(double, feed);
    QFETCH(double, rpm);
    QFETCH(double, acceleration);
    QFETCH(double, approachMm);
    QFETCH(double, approachSpeed);
    QFETCH(double, returnSpeed);
    QFETCH(int, field);
    QFETCH(double, speed);
    Machine machine;
    machine.pulsesPerMotorRev = 1000;
    machine.feedMmPerMotorRev = feed;
    machine.maxMotorRpm = rpm;
    machine.maxAccelerationMmPerS2 = acceleration;
    PressProgram program;
    program.approachPositionMm = approachMm;
    program.approachSpeedMmPerS = approachSpeed;
    program.returnSpeedMmPerS = returnSpeed;
    const auto motion = solve(program, machine);
    QVERIFY(motion.has_value());
    QVERIFY(!motion->broken.empty());
    QVERIFY(!isFeasible(program, machine));
    QVERIFY(!buildPressTable(program, machine).has_value());
    for (const Refusal& refusal : motion->broken) {
        QCOMPARE(refusal.nearest.size(), std::size_t(field < 0 ? 0 : 1));
        if (field < 0)
            continue;
        QCOMPARE(static_cast<int>(refusal.nearest[0].field), field);
        QVERIFY(isNear(refusal.nearest[0].value, speed));
    }
}

void TestPress::tableOfTheDefaults()
{
    const auto table = buildPressTable(PressProgram{}, Machine{});
    QVERIFY(table.has_value());
    const std::array<PressRow, pressStages> expected{{{8000, 6000, 200, 2},
                                                      {400, 9000, 200, 1},
                                                      {1000, 10000, 8000, 1},
                                                      {0, 10000, 8000, 500},
                                                      {8000, 0, 8000, 2}}};
    QVERIFY(table->rows == expected);
    QCOMPARE(table->cycleTicks, 70'368'000u); // 8.796 s at 8 MHz
    QVERIFY(isNear(table->positionErrorMm, 0));
    QVERIFY(isNear(table->speedErrorMmPerS, 0));
}

// 3 pulses in 1 mm: 60.1 mm is 180.3 pulses, 4.1 mm/s is 12.3 Hz.
void TestPress::tableStatesItsRounding()
{
    Machine machine;
    machine.pulsesPerMotorRev = 300;
    PressProgram program;
    program.approachPositionMm = 60.1;
    program.probeSpeedMmPerS = 4.1;
    const auto table = buildPressTable(program, machine);
    QVERIFY(table.has_value());
    QCOMPARE(table->rows[0].endPulses, 180);
    QCOMPARE(table->rows[1].speedHz, 12u);
    QVERIFY(isNear(table->positionErrorMm, 0.1));
    QVERIFY(isNear(table->speedErrorMmPerS, 0.1));
}

void TestPress::tableRefusesWhatItCannotHold()
{
    Machine fine;
    fine.pulsesPerMotorRev = 10'000'000;
    fine.feedMmPerMotorRev = 0.01;
    const auto far = buildPressTable(PressProgram{}, fine);
    QCOMPARE(static_cast<int>(far.error().limit), static_cast<int>(Limit::TableRange));
    QCOMPARE(far.error().actual, 1e11);

    Machine slow;
    slow.maxAccelerationMmPerS2 = 79;
    const auto ramp = buildPressTable(PressProgram{}, slow);
    QCOMPARE(static_cast<int>(ramp.error().limit), static_cast<int>(Limit::RampTooLong));
    QCOMPARE(static_cast<int>(ramp.error().field), static_cast<int>(Field::ApproachSpeed));
    QCOMPARE(ramp.error().actual, 1013.0);
    QCOMPARE(ramp.error().allowed, 1000.0);

    Machine coarse;
    coarse.pulsesPerMotorRev = 10; // 10 mm per pulse
    PressProgram close;
    close.probeEndMm = 64;
    const auto same = buildPressTable(close, coarse);
    QCOMPARE(static_cast<int>(same.error().limit), static_cast<int>(Limit::StageOrder));
    QCOMPARE(static_cast<int>(same.error().field), static_cast<int>(Field::ProbeEnd));
    QVERIFY(!solve(close, coarse).has_value());
    QCOMPARE(same.error().nearest.size(), std::size_t{2});
    QVERIFY(isNear(same.error().nearest[0].value, 65)); // half way to the next pulse
    QVERIFY(isNear(same.error().nearest[1].value, 54.99));

    // 200 kHz are 60 mm/s; the distance is too short for more than 29, but the row requires 80.
    Machine fast;
    fast.pulsesPerMotorRev = 20000;
    fast.feedMmPerMotorRev = 6;
    fast.maxAccelerationMmPerS2 = 2000;
    PressProgram brief;
    brief.approachPositionMm = 0.4;
    brief.returnSpeedMmPerS = 50;
    const auto row = solve(brief, fast);
    QCOMPARE(row->broken.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(row->broken[0].limit), static_cast<int>(Limit::PulseFrequency));
    QVERIFY(isNear(row->broken[0].nearest.at(0).value, 60));
    QVERIFY(!buildPressTable(brief, fast).has_value());
}

// Checks that a suggestion works alone, and that the grid point one step nearer to the present value does
// not.
void TestPress::verifySuggestions(const PressProgram& program, const Machine& machine,
                                  const std::vector<Suggestion>& suggestions)
{
    const auto works = [&](Field field, double x) {
        PressProgram mended = program;
        Machine other = machine;
        setValue(mended, field, x);
        setValue(other, field, x);
        return buildPressTable(mended, other).has_value() && solve(mended, other)->broken.empty();
    };
    for (const Suggestion& each : suggestions) {
        const QString name = QString::fromStdString(std::string(info(each.field).id));
        QVERIFY2(works(each.field, each.value), qPrintable(name));
        QCOMPARE(each.value, snapToGrid(each.field, each.value));
        const double present = value(program, each.field);
        const double step = std::copysign(info(each.field).resolution(), present - each.value);
        const double nearer = snapToGrid(each.field, each.value + step);
        if (std::abs(nearer - present) < std::abs(each.value - present) - 1e-9)
            QVERIFY2(!works(each.field, nearer), qPrintable(name));
    }
}

// Compares every value of every speed with the suggestions.
void TestPress::verifyNearestSpeed(const PressProgram& program, const Machine& machine,
                                   const std::vector<Suggestion>& suggestions)
{
    for (const Field field :
         {Field::ApproachSpeed, Field::ProbeSpeed, Field::PressSpeed, Field::ReturnSpeed}) {
        const FieldInfo& f = info(field);
        double least = std::numeric_limits<double>::infinity(); // distance to a speed that works
        for (double speed = f.min; speed < f.max + 0.05; speed += 0.1) {
            PressProgram mended = program;
            setValue(mended, field, snapToGrid(field, speed));
            if (isFeasible(mended, machine)) // compared with the table for every program
                least = std::min(least, std::abs(snapToGrid(field, speed) - value(program, field)));
        }
        const auto found = std::ranges::find(suggestions, field, &Suggestion::field);
        QCOMPARE(found != suggestions.end(), std::isfinite(least));
        if (found != suggestions.end())
            QVERIFY(isNear(std::abs(found->value - value(program, field)), least, 1e-6));
    }
}

// Programs and machines with many refusals: curve and table agree, and so do the suggestions.
void TestPress::randomSuggestionsWork()
{
    constexpr unsigned randomSeed = 17;
    qInfo("seed %u", randomSeed);
    std::mt19937_64 random(randomSeed);
    const auto between = [&random](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    int broken = 0;
    int mended = 0;
    int refused = 0;
    const int cases = campanel::test::randomCases(5'000);
    for (int i = 0; i < cases && !QTest::currentTestFailed(); ++i) {
        PressProgram program;
        for (const Field field :
             {Field::ApproachSpeed, Field::ProbeSpeed, Field::PressSpeed, Field::ReturnSpeed,
              Field::ProbeForce, Field::MaxForce, Field::MinStopForce, Field::MaxStopForce})
            setValue(program, field, snapToGrid(field, between(info(field).min, info(field).max)));
        const double scale = std::pow(10, between(-1.5, 3)); // mm
        for (const Field field : {Field::ApproachPosition, Field::ProbeEnd, Field::PressPosition})
            setValue(program, field, snapToGrid(field, between(0, scale)));
        if (i % 8 != 0)
            putInOrder(program);
        if (i % 16 == 1)
            setValue(program, Field::ReturnSpeed, between(0, 300));
        Machine machine;
        machine.pulsesPerMotorRev = static_cast<int>(std::pow(10, between(1, 5)));
        machine.feedMmPerMotorRev = snapToGrid(Field::FeedPerMotorRev, std::pow(10, between(0, 2)));
        machine.maxMotorRpm = std::round(between(50, 2000));
        machine.maxAccelerationMmPerS2 = std::round(std::pow(10, between(1.5, 4.5)));
        const auto motion = solve(program, machine);
        const auto table = buildPressTable(program, machine);
        QCOMPARE(table.has_value(), motion && motion->broken.empty());
        QCOMPARE(isFeasible(program, machine), table.has_value());
        if (!motion) {
            ++refused;
            verifySuggestions(program, machine, motion.error().nearest);
        } else if (!motion->broken.empty()) {
            ++broken;
            mended += motion->broken[0].nearest.empty() ? 0 : 1;
            verifySuggestions(program, machine, motion->broken[0].nearest);
            if (broken % 50 == 0)
                verifyNearestSpeed(program, machine, motion->broken[0].nearest);
        }
    }
    qInfo("%d refused, %d beyond a limit, %d of them mended by one speed", refused, broken, mended);
    if (QTest::currentTestFailed())
        return;
    QVERIFY(refused > cases / 20 && broken > cases / 4 && mended > cases / 20);
}

void TestPress::randomProgramsEndWhereTheyShould()
{
    constexpr unsigned seed = 11;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    int solved = 0;
    const int cases = campanel::test::randomCases();
    for (int i = 0; i < cases; ++i) {
        PressProgram program;
        for (const Field field :
             {Field::ApproachPosition, Field::ApproachSpeed, Field::ProbeSpeed, Field::ProbeForce,
              Field::ProbeEnd, Field::PressSpeed, Field::PressPosition, Field::HoldTime, Field::ReturnSpeed,
              Field::MaxForce, Field::PositionTolerance, Field::MinStopForce, Field::MaxStopForce}) {
            const FieldInfo& f = info(field);
            setValue(program, field,
                     snapToGrid(field, std::uniform_real_distribution<double>(f.min, f.max)(random)));
        }
        if (i % 4 != 0)
            putInOrder(program);
        Machine machine;
        machine.maxAccelerationMmPerS2 = std::uniform_real_distribution<double>(200, 50'000)(random);
        const auto stroke = solveStroke(program, machine);
        if (!stroke)
            continue;
        ++solved;
        QVERIFY(stroke->motion.broken.empty());
        const MotionProfile& motion = stroke->motion.motion;
        QVERIFY(isNear(motion.at(motion.durationS()).positionMm, 0, 1e-8));
        QVERIFY(isNear(motion.at(motion.durationS()).velocityMmPerS, 0, 1e-8));
        for (const StageSpan& stage : stroke->stages)
            QVERIFY(isNear(motion.at(stage.toS).positionMm, stage.toMm, 1e-8));
        const auto table = buildPressTable(program, machine);
        QVERIFY(table.has_value());
        QVERIFY(isNear(table->rows[2].endPulses * 0.01, program.pressPositionMm));
    }
    qInfo("%d of %d solved", solved, cases);
    QVERIFY(solved > cases / 10 * 7 && solved < cases / 10 * 9);
}

CAMPANEL_TEST(TestPress)

} // namespace test_press

#include "test_press.moc"
