// SPDX-License-Identifier: Apache-2.0
// The separate parts of a master: gear, tracker, clutch. What each must give was computed apart from the core
// in Python: the gear with its whole numbers of any length, the clutch as the polynomial of degree 5 that its
// six conditions have as their solution (Gauss, in fractions), the tracker as x += v t, x += alpha e,
// v += beta e / t in floating point.
#include "master/ctl_clutch.h"
#include "master/ctl_gear.h"
#include "master/ctl_tracker.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace test_master_parts {

namespace {

constexpr std::int64_t usPerS = 1'000'000;
constexpr std::uint32_t sliceUs = 250;

struct Line {
    double countsPerMm = 40.0;
    double ripple = 0.0;
    double rippleHz = 3.0;
    double accelerationMmPerS2 = 0.0; // from standstill to `speed`
    double speedMmPerS = 251.3;

    [[nodiscard]] double positionMm(double timeS) const
    {
        if (accelerationMmPerS2 > 0.0) {
            const double rampS = speedMmPerS / accelerationMmPerS2;
            return timeS < rampS ? accelerationMmPerS2 * timeS * timeS / 2.0
                                 : speedMmPerS * (timeS - rampS / 2.0);
        }
        const double angular = 2.0 * std::numbers::pi * rippleHz;
        return speedMmPerS * (timeS + ripple * (1.0 - std::cos(angular * timeS)) / angular);
    }

    [[nodiscard]] std::int64_t counts(double timeS) const
    {
        return static_cast<std::int64_t>(std::floor(positionMm(timeS) * countsPerMm));
    }
};

double secondsOf(std::int64_t us)
{
    return static_cast<double>(us) / usPerS;
}

// Returns the largest error of what the tracker says about the line `delayUs` later, led by `leadUs`.
double largestErrorMm(const Line& line, std::uint32_t constantUs, std::uint32_t leadUs)
{
    constexpr std::int64_t delayUs = 1250;
    ctl_tracker tracker{};
    ctl_tracker_reset(&tracker, 0, constantUs);
    tracker.still_us = 0; // it moves already: a single count is no noise
    double largest = 0.0;
    const bool speedsUp = line.accelerationMmPerS2 > 0.0;
    const double endS = speedsUp ? line.speedMmPerS / line.accelerationMmPerS2 : 4.0;
    for (std::int64_t us = sliceUs; secondsOf(us) < endS; us += sliceUs) {
        ctl_tracker_pass(&tracker, sliceUs);
        ctl_tracker_read(&tracker, line.counts(secondsOf(us)));
        const ctl_tracked led = ctl_tracker_ahead(&tracker, leadUs);
        // A count is read anywhere behind its edge: on average half of it.
        const double ledMm =
            (static_cast<double>(led.count) + led.fraction / 65536.0 + 0.5) / line.countsPerMm;
        if (speedsUp || us > usPerS / 2)
            largest = std::max(largest, std::abs(ledMm - line.positionMm(secondsOf(us + delayUs))));
    }
    return largest;
}

} // namespace

class TestMasterParts : public QObject {
    Q_OBJECT

private slots:
    void aGearIsExactAfterAMillionSteps_data();
    void aGearIsExactAfterAMillionSteps();
    void aGearComesBackToWhereItWas();
    void aGearDoesNotFallWithinACount();
    void aTrackerLeadsWithoutLag_data();
    void aTrackerLeadsWithoutLag();
    void aTrackerStandsOnItsCount();
    void aTrackerThatStandsIgnoresAnEdgeToAndFro();
    void aTrackerReadsTheSameWhateverTheSteps();
    void aTrackerBeginsAnewBehindAJump();
    void aClutchMeetsTheCurve_data();
    void aClutchMeetsTheCurve();
    void aClutchNeverGoesBack();
    void aClutchDisengagesAtItsEnd();
    void aClutchIsALineOfTheMasterAlone();
};

using Marks = std::array<std::int64_t, 5>;

void TestMasterParts::aGearIsExactAfterAMillionSteps_data()
{
    QTest::addColumn<quint64>("numerator");
    QTest::addColumn<quint64>("denominator");
    QTest::addColumn<Marks>("ticks");
    QTest::newRow("bag of 123.457 mm") << quint64{2'000'000'000'000} << quint64{1'234'570'000}
                                       << Marks{-84'240, -108'540, 800'971'998, 32'467'383'785, 126'832'824};
    QTest::newRow("a cycle that is a tick shorter")
        << quint64{1'999'999'750'000} << quint64{1'234'570'000}
        << Marks{-84'240, -108'540, 800'971'898, 32'467'379'727, 126'832'808};
    QTest::newRow("few counts") << quint64{349'065'520'649} << quint64{1'087'312'000}
                                << Marks{-16'694, -21'510, 158'728'835, 6'434'070'130, 25'134'494};
    QTest::newRow("less than a tick per count")
        << quint64{3} << quint64{7} << Marks{-23, -29, 211'897, 8'589'269, 33'553};
    QTest::newRow("625 lines") << quint64{5'333'333'000'000} << quint64{250'007'500}
                               << Marks{-1'109'300, -1'429'291, 10'547'480'249, 427'541'899'020,
                                        1'670'179'123};
}

// Forward for the most part of half a million steps, then back.
void TestMasterParts::aGearIsExactAfterAMillionSteps()
{
    QFETCH(quint64, numerator);
    QFETCH(quint64, denominator);
    QFETCH(Marks, ticks);
    constexpr std::array marks{0, 1, 12345, 499'999, 999'999};
    constexpr std::int64_t origin = -77;
    ctl_gear gear{};
    ctl_gear_set(&gear, numerator, denominator, origin);
    std::uint64_t random = 1;
    std::int64_t count = origin;
    std::size_t next = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        count += static_cast<std::int64_t>((random >> 33u) % 201u) - (i < 500'000 ? 60 : 140);
        const std::int64_t at = ctl_gear_ticks(&gear, count, 0);
        if (i == marks.at(next)) {
            QCOMPARE(at, ticks.at(next));
            next = std::min(next + 1, marks.size() - 1);
        }
    }
    QCOMPARE(next, marks.size() - 1);
}

void TestMasterParts::aGearComesBackToWhereItWas()
{
    ctl_gear gear{};
    ctl_gear_set(&gear, 349'065'520'649, 1'087'312'000, 0);
    for (int i = 0; i < 1'000'000; ++i)
        (void)ctl_gear_ticks(&gear, i, 0);
    (void)ctl_gear_ticks(&gear, 4'000'000'000, 0);              // in one step
    QCOMPARE(ctl_gear_ticks(&gear, 1'000'000, 0), 321'035'287); // 10^6 * N // D
    for (int i = 1'000'000; i > 0; --i)
        (void)ctl_gear_ticks(&gear, i, 0);
    QCOMPARE(ctl_gear_ticks(&gear, 0, 0), 0);
    QCOMPARE(gear.remainder, 0u);
}

void TestMasterParts::aGearDoesNotFallWithinACount()
{
    ctl_gear gear{};
    ctl_gear_set(&gear, 1'999'999'750'000, 1'234'570'000, 0);
    std::int64_t last = ctl_gear_ticks(&gear, -20, 0);
    for (std::int64_t count = -20; count < 20; ++count) {
        for (std::uint32_t fraction = 0; fraction < 65'536; fraction += 31) {
            const std::int64_t ticks = ctl_gear_ticks(&gear, count, fraction);
            QVERIFY(ticks >= last && ticks - last <= 2);
            last = ticks;
        }
    }
}

void TestMasterParts::aTrackerLeadsWithoutLag_data()
{
    QTest::addColumn<double>("countsPerMm");
    QTest::addColumn<int>("constantUs");
    QTest::addColumn<double>("ripple");
    QTest::addColumn<double>("rippleHz");
    QTest::addColumn<double>("acceleration");
    QTest::addColumn<double>("errorMm");
    QTest::addColumn<double>("withoutLeadMm");
    QTest::newRow("2500, constant speed") << 10.0 << 5000 << 0.0 << 3.0 << 0.0 << 0.0074 << 0.3208;
    QTest::newRow("2500, 1 % at 3 Hz") << 10.0 << 5000 << 0.01 << 3.0 << 0.0 << 0.0112 << 0.3232;
    QTest::newRow("2500, 1 % at 11 Hz") << 10.0 << 5000 << 0.01 << 11.0 << 0.0 << 0.0152 << 0.3257;
    QTest::newRow("10 000, constant speed") << 40.0 << 5000 << 0.0 << 3.0 << 0.0 << 0.0044 << 0.3180;
    QTest::newRow("10 000, 1 % at 3 Hz") << 40.0 << 5000 << 0.01 << 3.0 << 0.0 << 0.0084 << 0.3205;
    QTest::newRow("10 000, 1 m/s^2") << 40.0 << 5000 << 0.0 << 3.0 << 1000.0 << 0.0417 << 0.3353;
    QTest::newRow("10 000, 2 ms, 1 % at 11 Hz") << 40.0 << 2000 << 0.01 << 11.0 << 0.0 << 0.0111 << 0.3220;
    QTest::newRow("10 000, 2 ms, 1 m/s^2") << 40.0 << 2000 << 0.0 << 3.0 << 1000.0 << 0.0217 << 0.3148;
}

void TestMasterParts::aTrackerLeadsWithoutLag()
{
    QFETCH(double, countsPerMm);
    QFETCH(int, constantUs);
    QFETCH(double, ripple);
    QFETCH(double, rippleHz);
    QFETCH(double, acceleration);
    QFETCH(double, errorMm);
    QFETCH(double, withoutLeadMm);
    const Line line{countsPerMm, ripple, rippleHz, acceleration};
    const auto constant = static_cast<std::uint32_t>(constantUs);
    // Where exactly the counts fall in the slices moves the largest error by some micrometers.
    constexpr double closeMm = 0.002;
    const double ledMm = largestErrorMm(line, constant, 1250);
    const double lateMm = largestErrorMm(line, constant, 0);
    QVERIFY2(std::abs(ledMm - errorMm) < closeMm, qPrintable(QString::number(ledMm)));
    QVERIFY2(std::abs(lateMm - withoutLeadMm) < closeMm, qPrintable(QString::number(lateMm)));
}

void TestMasterParts::aTrackerStandsOnItsCount()
{
    ctl_tracker tracker{};
    ctl_tracker_reset(&tracker, 1000, 5000);
    QVERIFY(ctl_tracker_stands(&tracker));
    std::int64_t count = 1000;
    for (int i = 0; i < 1000; ++i) { // forward, then back, then still
        count += i < 400 ? 3 : i < 600 ? -2 : 0;
        ctl_tracker_pass(&tracker, sliceUs);
        ctl_tracker_read(&tracker, count);
        if (i == 399)
            QVERIFY(!ctl_tracker_stands(&tracker));
    }
    QVERIFY(ctl_tracker_stands(&tracker));
    const ctl_tracked at = ctl_tracker_ahead(&tracker, 20'000);
    QCOMPARE(at.count, 1000 + 1200 - 400);
    QCOMPARE(at.fraction, 0u);
}

void TestMasterParts::aTrackerThatStandsIgnoresAnEdgeToAndFro()
{
    ctl_tracker tracker{};
    ctl_tracker_reset(&tracker, 1000, 5000);
    for (int i = 0; i < 1000; ++i) {
        ctl_tracker_pass(&tracker, sliceUs);
        ctl_tracker_read(&tracker, 1000 + i / 7 % 2);
        QCOMPARE(ctl_tracker_ahead(&tracker, 5000).count, 1000);
        QCOMPARE(ctl_tracker_ahead(&tracker, 5000).fraction, 0u);
    }
    for (int i = 0; i < 4000; ++i) {
        ctl_tracker_pass(&tracker, sliceUs);
        ctl_tracker_read(&tracker, 1003);
    }
    QCOMPARE(ctl_tracker_ahead(&tracker, 5000).count, 1003);
}

// A call that was late is cut into slices that all read the counts of its end: only the last one counts.
void TestMasterParts::aTrackerReadsTheSameWhateverTheSteps()
{
    const Line line{};
    ctl_tracker even{};
    ctl_tracker cut{};
    ctl_tracker_reset(&even, 0, 5000);
    ctl_tracker_reset(&cut, 0, 5000);
    for (std::int64_t us = 1000; us <= usPerS; us += 1000) {
        const std::int64_t counts = line.counts(secondsOf(us));
        ctl_tracker_pass(&even, 1000);
        ctl_tracker_read(&even, counts);
        for (int i = 0; i < 4; ++i)
            ctl_tracker_pass(&cut, 250);
        ctl_tracker_read(&cut, counts);
        QCOMPARE(cut.ahead, even.ahead);
        QCOMPARE(cut.speed, even.speed);
    }
}

void TestMasterParts::aTrackerBeginsAnewBehindAJump()
{
    ctl_tracker tracker{};
    ctl_tracker_reset(&tracker, 0, 5000);
    ctl_tracker_pass(&tracker, sliceUs);
    ctl_tracker_read(&tracker, std::int64_t{1} << 40u);
    const ctl_tracked at = ctl_tracker_ahead(&tracker, 5000);
    QCOMPARE(at.count, std::int64_t{1} << 40u);
    QCOMPARE(at.fraction, 0u);
}

using Points = std::array<std::array<std::int64_t, 2>, 6>;

void TestMasterParts::aClutchMeetsTheCurve_data()
{
    QTest::addColumn<quint32>("stretch");
    QTest::addColumn<quint32>("way");
    QTest::addColumn<Points>("points");
    QTest::newRow("half of the stretch") << 4'000'000u << 2'000'000u
                                         << Points{{{400'000, 3'800},
                                                    {1'000'000, 54'687},
                                                    {2'000'000, 375'000},
                                                    {3'000'000, 1'054'687},
                                                    {3'600'000, 1'603'800},
                                                    {3'999'999, 1'999'999}}};
    QTest::newRow("0.4 of it") << 4'000'000u << 1'600'000u
                               << Points{{{400'000, 376},
                                          {1'000'000, 13'281},
                                          {2'000'000, 175'000},
                                          {3'000'000, 696'093},
                                          {3'600'000, 1'207'224},
                                          {3'999'999, 1'599'999}}};
    QTest::newRow("0.6 of it") << 4'000'000u << 2'400'000u
                               << Points{{{400'000, 7'224},
                                          {1'000'000, 96'093},
                                          {2'000'000, 575'000},
                                          {3'000'000, 1'413'281},
                                          {3'600'000, 2'000'376},
                                          {3'999'999, 2'399'999}}};
    QTest::newRow("odd") << 123'457u << 60'001u
                         << Points{{{12'345, 102},
                                    {30'864, 1'509},
                                    {61'728, 10'710},
                                    {92'592, 31'002},
                                    {111'111, 47'787},
                                    {123'456, 60'000}}};
    QTest::newRow("long") << 4'000'000'000u << 2'000'000'001u
                          << Points{{{400'000'000, 3'800'000},
                                     {1'000'000'000, 54'687'500},
                                     {2'000'000'000, 375'000'000},
                                     {3'000'000'000, 1'054'687'500},
                                     {3'600'000'000, 1'603'800'000},
                                     {3'999'999'999, 2'000'000'000}}};
}

void TestMasterParts::aClutchMeetsTheCurve()
{
    QFETCH(quint32, stretch);
    QFETCH(quint32, way);
    QFETCH(Points, points);
    constexpr std::int64_t master = -123'456'789;
    constexpr std::int64_t line = 987'654'321;
    ctl_clutch clutch{};
    ctl_clutch_open(&clutch, line);
    QCOMPARE(ctl_clutch_follow(&clutch, master), line);
    ctl_clutch_engage(&clutch, master, line, {stretch, way});
    QCOMPARE(ctl_clutch_follow(&clutch, master), line);
    const std::int64_t close = 2 + static_cast<std::int64_t>(stretch) / 100'000'000; // of 30 bits
    for (const auto& [passed, wanted] : points) {
        const std::int64_t got = ctl_clutch_follow(&clutch, master + passed) - line;
        QVERIFY2(std::abs(got - wanted) <= close, qPrintable(QString::number(got)));
    }
    QCOMPARE(clutch.state, CTL_CLUTCH_ENGAGING);
    for (const std::int64_t behind : {0, 1, 77'777}) {
        QCOMPARE(ctl_clutch_follow(&clutch, master + stretch + behind), line + way + behind);
        QCOMPARE(clutch.state, CTL_CLUTCH_ON);
    }
}

void TestMasterParts::aClutchNeverGoesBack()
{
    for (const std::uint32_t way : {400'000u, 450'000u, 500'000u, 567'891u, 600'000u}) {
        ctl_clutch clutch{};
        ctl_clutch_engage(&clutch, 0, 0, {1'000'000, way});
        ctl_clutch_disengage(&clutch, 3'000'000, {1'000'000, way});
        std::int64_t last = 0;
        for (std::int64_t master = 0; master < 6'000'000; master += 97) {
            const std::int64_t line = ctl_clutch_follow(&clutch, master);
            // The last bits may be a tick too many or too few.
            QVERIFY(line >= last - 1 && line - last < 4 * 97);
            last = line;
        }
        QCOMPARE(last, 3'000'000);
        QCOMPARE(clutch.state, CTL_CLUTCH_OFF);
    }
}

void TestMasterParts::aClutchDisengagesAtItsEnd()
{
    ctl_clutch clutch{};
    const ctl_clutch_curve curve{1'000'000, 500'000};
    ctl_clutch_engage(&clutch, 0, 0, curve);
    QCOMPARE(ctl_clutch_nearest_end(&clutch, 100, curve), 1'000'000); // not before it has engaged
    QCOMPARE(ctl_clutch_follow(&clutch, 2'000'000), 1'500'000);
    QCOMPARE(ctl_clutch_nearest_end(&clutch, 1'500'000, curve), 2'000'000);
    ctl_clutch_disengage(&clutch, 8'000'000, curve);
    QCOMPARE(ctl_clutch_follow(&clutch, 8'000'000), 7'500'000); // up to here as the master
    // As far behind standstill as it was before it, the curve mirrored.
    QVERIFY(std::abs(ctl_clutch_follow(&clutch, 8'250'000) - (8'000'000 - 263'671)) <= 1);
    QVERIFY(std::abs(ctl_clutch_follow(&clutch, 8'500'000) - (8'000'000 - 93'750)) <= 1);
    QVERIFY(std::abs(ctl_clutch_follow(&clutch, 8'750'000) - (8'000'000 - 13'671)) <= 1);
    QCOMPARE(clutch.state, CTL_CLUTCH_DISENGAGING);
    QCOMPARE(ctl_clutch_follow(&clutch, 9'000'000), 8'000'000);
    QCOMPARE(clutch.state, CTL_CLUTCH_OFF);
    QCOMPARE(ctl_clutch_follow(&clutch, 20'000'000), 8'000'000);
}

// It does not matter in which steps the master comes, nor that it went back meanwhile.
void TestMasterParts::aClutchIsALineOfTheMasterAlone()
{
    ctl_clutch clutch{};
    ctl_clutch_engage(&clutch, 0, 0, {1'000'000, 500'000});
    ctl_clutch_disengage(&clutch, 3'000'000, {1'000'000, 500'000});
    QCOMPARE(ctl_clutch_follow(&clutch, -200'000), 0); // not before it began
    for (const std::int64_t master : {300'000, 900'000, 2'000'000, 3'200'000, 3'900'000}) {
        const std::int64_t line = ctl_clutch_follow(&clutch, master);
        (void)ctl_clutch_follow(&clutch, master - 250'000);
        QCOMPARE(ctl_clutch_follow(&clutch, master), line);
    }
}

CAMPANEL_TEST(TestMasterParts)

} // namespace test_master_parts

#include "test_master_parts.moc"
