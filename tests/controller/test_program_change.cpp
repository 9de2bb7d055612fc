// SPDX-License-Identifier: Apache-2.0
// The change of program while the machine runs: no axis steps further than it may, and nothing is lost.
#include "change_bench.h"

#include "base/ctl_words.h"
#include "motion/ctl_change.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace test_program_change {

using namespace campanel::test;
using namespace campanel::test::change;
using campanel::controller::MachineOptions;

namespace {

constexpr std::size_t window = 4; // slices in which a speed is measured

struct Axes {
    double knife = 0.0;
    double film = 0.0;
    double infeed = 0.0;
};

Axes operator+(const Axes& a, const Axes& b)
{
    return {a.knife + b.knife, a.film + b.film, a.infeed + b.infeed};
}

Axes operator-(const Axes& a, const Axes& b)
{
    return {a.knife - b.knife, a.film - b.film, a.infeed - b.infeed};
}

// Returns where the axes are commanded to, in pulses; finer than whole ones.
Axes positions(Rig& rig)
{
    const ctl_motion& motion = rig.core().motion;
    const ctl_step& step = motion.table.step;
    const double part = ctl_step_between_cycles(&step)
                            ? 0.0
                            : static_cast<double>(step.current.pulses) * step.row_ticks / step.current.ticks -
                                  ctl_step_row_pulses(&step);
    return {static_cast<double>(motion.commanded) + part,
            static_cast<double>(ctl_feed_position(&rig.core().packer.film)) / CTL_FINE,
            static_cast<double>(ctl_feed_position(&rig.core().packer.infeed)) / CTL_FINE};
}

struct Change {
    Axes step; // largest steps of the speeds at the boundary, Hz
    double timeS = 0.0;
    double share = 1.0; // smallest share of full speed
    bool isThroughProduct = false;
};

// The resolution of these speeds: positions are in 1/256 pulse, the master moves by whole ticks, and a
// correction of the film or the infeed may begin at the boundary.
constexpr double resolutionHz = 80.0;

// Runs the rig until the armed program has taken over and runs at full speed. The boundary lies inside
// of a slice; the speeds on both sides are those next to it.
Change follow(Rig& rig)
{
    const std::uint32_t generation = rig.core().banks.generation;
    const std::uint64_t beganUs = rig.controller().nowUs();
    Change change;
    std::array<Axes, 6 * window> at{};
    const auto step = [&] {
        rig.controller().step();
        std::rotate(at.begin(), at.begin() + 1, at.end());
        at.back() = positions(rig);
        change.isThroughProduct =
            change.isThroughProduct || (rig.controller().cut() && rig.controller().cut()->throughProduct);
        change.share = std::min(change.share, static_cast<double>(rig.core().motion.ramp.speed) /
                                                  rig.core().motion.ramp.full);
    };
    while (rig.core().banks.generation == generation) {
        step();
        if (rig.controller().nowUs() - beganUs > 120 * second)
            return change;
    }
    for (std::size_t i = 0; i < 2 * window; ++i)
        step();
    // Travel in the windows next to the slice of the boundary, with the ramp's part of the way to it.
    const std::size_t last = at.size() - 1 - 2 * window; // the end of that slice
    const auto travel = [&](std::size_t end) { return at[end] - at[end - window]; };
    const Axes before = travel(last - 1) + (travel(last - 1) - travel(last - 1 - window));
    const Axes behind = travel(last + window) - (travel(last + 2 * window) - travel(last + window));
    const double hz = 1e6 / 250.0 / window;
    change.step = {std::abs(behind.knife - before.knife) * hz, std::abs(behind.film - before.film) * hz,
                   std::abs(behind.infeed - before.infeed) * hz};
    while (rig.core().motion.ramp.speed < rig.core().motion.ramp.full)
        step();
    change.timeS = static_cast<double>(rig.controller().nowUs() - beganUs) / 1e6;
    return change;
}

} // namespace

class TestProgramChange : public QObject {
    Q_OBJECT

private slots:
    void rampApproachesASpeed();
    void speedOfAShareIsItsInverse();
    void sameLengthOnlyRamps();
    void stopInTheMiddleTakesOverAtStandstill_data();
    void stopInTheMiddleTakesOverAtStandstill();
    void cancelInTheMiddleSpeedsUpAgain();
    void lostHeartbeatInTheMiddle();
    void impossibleStepIsRefused();
    void knifeStandsOpenOverAProduct();
    void pointCamsKeepTheStepOfTheirAxis();
    void anotherRateKeepsTheRegister();
    void windowElsewhere_data();
    void windowElsewhere();
    void randomPairsKeepTheirSteps();
};

void TestProgramChange::rampApproachesASpeed()
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        const auto pick = [&](std::uint32_t low, std::uint32_t high) {
            return std::uniform_int_distribution<std::uint32_t>(low, high)(random);
        };
        ctl_ramp ramp;
        if (i % 2 == 0)
            ctl_ramp_reset(&ramp, pick(400'000, 8'000'000));
        else
            ctl_ramp_reset_s(&ramp, pick(400'000, 8'000'000));
        ramp.speed = pick(0, ramp.full);
        // Not below the smallest share of a change, of the S-curve 2 x^2.
        const std::uint32_t end = pick(ramp.full / (ramp.s_curve ? 60 : 1000), ramp.full);
        std::uint64_t remaining = pick(1, 20'000'000);
        while (!ctl_ramp_can_approach(&ramp, remaining, end))
            remaining += 1'000'000;
        std::uint32_t fastest = 0;
        while (remaining != 0) {
            const std::uint32_t speed = ramp.speed;
            const std::uint32_t travelled = ctl_ramp_approach(&ramp, 2000, remaining, end);
            // Up or down by one per tick at most, and a little for the rounding of the root.
            QVERIFY2(ramp.speed <= speed + 2000 && ramp.speed + 2250 >= speed,
                     qPrintable(QStringLiteral("%1: %2 to %3 of %4, %5 to %6 (end %7)")
                                    .arg(i)
                                    .arg(speed)
                                    .arg(ramp.speed)
                                    .arg(ramp.full)
                                    .arg(remaining)
                                    .arg(travelled)
                                    .arg(end)));
            fastest = std::max(fastest, ramp.speed);
            if (travelled >= remaining)
                break;
            remaining -= travelled;
        }
        QVERIFY2(
            ramp.speed <= end + 2 * 2000,
            qPrintable(
                QStringLiteral("%1: %2 instead of %3 of %4").arg(i).arg(ramp.speed).arg(end).arg(ramp.full)));
        QVERIFY(fastest <= ramp.full);
    }
}

// Against the share of the S-curve in floating point: 2 x^2 below the middle, 1 - 2 (1 - x)^2 above it.
void TestProgramChange::speedOfAShareIsItsInverse()
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 10'000; ++i) {
        ctl_ramp ramp;
        const auto full = std::uniform_int_distribution<std::uint32_t>(400'000, 8'000'000)(random);
        if (i % 2 == 0)
            ctl_ramp_reset(&ramp, full);
        else
            ctl_ramp_reset_s(&ramp, full);
        const double x = std::uniform_real_distribution(0.01, 1.0)(random);
        const double curved = x <= 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x);
        const double share = std::ldexp(ramp.s_curve ? curved : x, CTL_RAMP_SHARE_BITS);
        ramp.speed = ctl_ramp_speed_of(&ramp, static_cast<std::uint64_t>(share));
        // One speed more or less is a share of 2 / full at most, in the middle of the S-curve.
        const double allowed = std::ldexp(ramp.s_curve ? 4.0 : 2.0, CTL_RAMP_SHARE_BITS) / full;
        const auto found = static_cast<double>(ctl_ramp_whole_share(&ramp));
        QVERIFY2(std::abs(found - share) <= allowed,
                 qPrintable(QStringLiteral("%1: %2 instead of %3, %4 of %5")
                                .arg(i)
                                .arg(found)
                                .arg(share)
                                .arg(ramp.speed)
                                .arg(full)));
        QVERIFY(std::abs(ramp.speed - x * full) <= 1e-3 * full);
    }
}

// 60 to 120 bags a minute of the same length: film and knife keep their speed, only the ramp follows.
void TestProgramChange::sameLengthOnlyRamps()
{
    Rig rig(calm());
    setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, 100);
    rig.install(cutter(250'000, 60));
    rig.start();
    rig.run(10 * second);
    arm(rig, cutter(250'000, 120), 2);
    const Change change = follow(rig);
    QVERIFY2(std::abs(change.share - 0.5) < 0.01, qPrintable(QString::number(change.share)));
    QVERIFY2(
        change.step.film < 40 && change.step.knife < 40 && change.step.infeed < 40,
        qPrintable(
            QStringLiteral("%1 %2 %3").arg(change.step.film).arg(change.step.knife).arg(change.step.infeed)));
}

// Returns a running rig whose change to 100 mm has just begun to slow down.
struct SlowingRig : Rig {
    SlowingRig()
        : Rig(calm())
    {
        install(cutter(250'000, 200));
        start();
        run(10 * second);
        arm(*this, cutter(100'000, 200), 2);
        while (core().motion.ramp.speed > core().motion.ramp.full * 9 / 10)
            controller().step();
    }
};

void TestProgramChange::stopInTheMiddleTakesOverAtStandstill_data()
{
    QTest::addColumn<int>("code");
    QTest::newRow("at cycle end") << int{CTL_COMMAND_STOP_AT_CYCLE_END};
    QTest::newRow("at once") << int{CTL_COMMAND_STOP_NOW};
}

void TestProgramChange::stopInTheMiddleTakesOverAtStandstill()
{
    QFETCH(int, code);
    SlowingRig rig;
    QCOMPARE(rig.core().banks.generation, 1u);
    QCOMPARE(rig.command(static_cast<std::uint16_t>(code)), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const bool isAtBoundary = code == CTL_COMMAND_STOP_AT_CYCLE_END;
    QCOMPARE(rig.core().banks.generation, isAtBoundary ? 2u : 1u);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    rig.run(10 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 2u);
    QCOMPARE(rig.core().motion.ramp.speed, rig.core().motion.ramp.full);
}

void TestProgramChange::cancelInTheMiddleSpeedsUpAgain()
{
    SlowingRig rig;
    // A second download waits until the first one is over.
    QCOMPARE(rig.download(cutter(300'000, 100).registers(), 3), CTL_TRANSFER_RESULT_STATE_REFUSES);
    QCOMPARE(rig.command(CTL_COMMAND_CANCEL_APPLY), CTL_REFUSAL_NONE);
    rig.run(2 * second);
    QCOMPARE(rig.core().banks.generation, 1u);
    QCOMPARE(rig.core().motion.ramp.speed, rig.core().motion.ramp.full);
    arm(rig, cutter(300'000, 100), 3);
    rig.run(10 * second);
    QCOMPARE(rig.core().banks.generation, 2u);
    QCOMPARE(rig.core().banks.active_crc, crc32(cutter(300'000, 100).registers()));
}

// The line breaks: by its parameter the machine stops at the end of a cycle, with the new program.
void TestProgramChange::lostHeartbeatInTheMiddle()
{
    Rig rig(calm());
    rig.install(cutter(250'000, 60));
    rig.start();
    rig.heartbeat();
    rig.setParameter(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, 300);
    rig.setParameter(CTL_REG_PARAMETER_HEARTBEAT_LOST_ACTION, CTL_HEARTBEAT_LOST_ACTION_STOP_AT_CYCLE_END);
    for (int i = 0; i < 100; ++i) {
        rig.heartbeat();
        rig.run(100'000);
    }
    arm(rig, cutter(100'000, 200), 2);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.core().packer.master, 0u);
    QCOMPARE(rig.core().banks.generation, 2u);
}

void TestProgramChange::impossibleStepIsRefused()
{
    Rig rig(calm());
    setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, 10);
    setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, 10);
    rig.install(cutter(460'000, 90));
    rig.start();
    rig.run(10 * second);
    const Registers image = cutter(100'000, 300).registers();
    QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_STEP_TOO_LARGE);
    rig.run(5 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 1u);
    // At standstill it is a change like any other.
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().banks.generation, 2u);
}

// Products 100 mm apart lie under every first cut of 400 mm, 200 mm behind the boundary.
void TestProgramChange::knifeStandsOpenOverAProduct()
{
    Rig rig(calm());
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
    rig.install(cutter(100'000, 120));
    rig.start();
    rig.run(20 * second);
    const std::uint32_t skipped = rig.core().packer.skipped;
    arm(rig, cutter(400'000, 60), 2);
    const Change change = follow(rig);
    QCOMPARE(rig.core().banks.generation, 2u);
    QVERIFY(!change.isThroughProduct);
    QVERIFY(rig.core().packer.skipped > skipped);
    const QString wrong = wrongAfter(rig, 400'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

// The axis passes the boundary with another slope; its master keeps its speed.
void TestProgramChange::pointCamsKeepTheStepOfTheirAxis()
{
    const CamImage one = sineCam(3000.0, 300.0, 100, 2'400'000);
    const CamImage other = sineCam(3000.0, -300.0, 64, 2'400'000);
    std::array<std::int64_t, 2> jolts{};
    for (const bool isGentle : {false, true}) {
        Rig rig;
        setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, isGentle ? 200 : 1'000'000);
        rig.install(one.registers());
        rig.start();
        rig.run(second);
        const Registers image = other.registers();
        QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
        jolts[isGentle ? 1 : 0] = rig.maxJolt(4 * second);
        QCOMPARE(rig.core().banks.generation, 2u);
        rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        QCOMPARE(rig.commanded(), std::int64_t{3000} * rig.core().motion.cycle_count);
    }
    // Pulses a slice: a step of thousands of Hz is two pulses more, one of 200 Hz is lost in the rounding.
    QVERIFY2(jolts[1] < jolts[0], qPrintable(QStringLiteral("%1 and %2").arg(jolts[0]).arg(jolts[1])));
}

// The film is stretched, and the drives lag by more at the new rate: the first cut already follows its mark.
void TestProgramChange::anotherRateKeepsTheRegister()
{
    MachineOptions options = calm();
    options.film.stretch = 0.005;
    for (const double rate : {30.0, 100.0, 200.0}) {
        Rig rig(options);
        rig.install(cutter(250'000, 60));
        rig.start();
        rig.run(20 * second);
        arm(rig, cutter(250'000, rate), 2);
        const ctl_packer& packer = rig.core().packer;
        for (int bags = 0; bags < 8;) {
            rig.controller().step();
            if (!rig.controller().cut())
                continue;
            ++bags;
            QVERIFY2(!packer.last_cut.scrap, QByteArray::number(bags));
            QVERIFY2(std::abs(rig.controller().cut()->markErrorMm) <= 0.2,
                     QByteArray::number(rig.controller().cut()->markErrorMm));
        }
        QCOMPARE(rig.core().banks.generation, 2u);
    }
}

void TestProgramChange::windowElsewhere_data()
{
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("end");
    QTest::addColumn<bool>("isRunning");
    for (const bool isRunning : {true, false}) {
        const char* how = isRunning ? "running" : "at standstill";
        QTest::addRow("the same place, narrower, %s", how) << 0.45 << 0.55 << isRunning;
        QTest::addRow("2 mm later, %s", how) << 0.4 << 0.616 << isRunning;
        QTest::addRow("4 mm later, %s", how) << 0.4 << 0.632 << isRunning;
        QTest::addRow("8.3 mm later, %s", how) << 0.4 << 0.667 << isRunning;
        QTest::addRow("60 mm earlier, %s", how) << 0.1 << 0.42 << isRunning;
        QTest::addRow("37.5 mm later, %s", how) << 0.55 << 0.75 << isRunning;
    }
}

// The same bag with its sealing window at another place of the cycle: film and products are brought there.
void TestProgramChange::windowElsewhere()
{
    QFETCH(double, start);
    QFETCH(double, end);
    QFETCH(bool, isRunning);
    Rig rig(calm());
    rig.install(cutter(250'000, 60));
    rig.start();
    rig.run(20 * second);
    const BankImage next = cutter(250'000, 60, {start, end});
    if (!isRunning) {
        rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
    }
    arm(rig, next, 2);
    if (isRunning)
        follow(rig);
    else
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().banks.generation, 2u);
    const QString wrong = wrongAfter(rig, 250'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestProgramChange::randomPairsKeepTheirSteps()
{
    const int pairs = std::max(15, qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES"));
    std::mt19937_64 random(19);
    std::vector<double> times;
    Axes largest; // steps over their limits; of the film in Hz
    int broken = 0;
    for (int i = 0; i < pairs; ++i) {
        const auto pick = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const auto knives = static_cast<std::uint16_t>(1 << random() % 3); // 1, 2 or 4
        const auto any = [&] {
            const double lengthMm = pick(0, 1) < 0.3 ? 250 : pick(100, 460);
            const double middle = pick(0.3, 0.7);
            const double half = pick(0.05, 0.2);
            return cutter(static_cast<std::uint32_t>(lengthMm * 1000),
                          pick(30, std::min(350.0, 60.0 * 700.0 / lengthMm)),
                          {middle - half, middle + half, pick(0.9, 1.1), pick(0, 0.6), knives});
        };
        MachineOptions options = calm();
        options.film.stretch = i % 2 == 0 ? 0.0 : 0.005;
        options.products.lengthMm = pick(20, 60);
        options.products.missing = i % 3 == 0 ? pick(0, 1) : 0.0;
        options.seed = static_cast<std::uint64_t>(i) + 1;
        Rig rig(options);
        rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
        const std::array<std::uint32_t, 3> limits{static_cast<std::uint32_t>(pick(300, 5000)),
                                                  static_cast<std::uint32_t>(pick(300, 3000)),
                                                  static_cast<std::uint32_t>(pick(300, 3000))};
        setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, limits[0]);
        setLimit(rig, CTL_REG_PARAMETER_FILM_STEP, limits[1]);
        setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, limits[2]);
        rig.install(any());
        rig.start();
        rig.run(10 * second);
        const BankImage next = any();
        arm(rig, next, 2);
        const Change change = follow(rig);
        QCOMPARE(rig.core().banks.generation, 2u);
        QVERIFY2(!change.isThroughProduct, QByteArray::number(i));
        const bool isKept = change.step.knife <= 1.01 * limits[0] + resolutionHz &&
                            change.step.film <= resolutionHz &&
                            change.step.infeed <= 1.01 * limits[2] + resolutionHz;
        broken += isKept ? 0 : 1;
        largest = {std::max(largest.knife, change.step.knife / limits[0]),
                   std::max(largest.film, change.step.film),
                   std::max(largest.infeed, change.step.infeed / limits[2])};
        times.push_back(change.timeS);
        // The way from the laying place to the knife is stretched, too.
        const double productMm = 1.0 + options.film.stretch * options.products.layMm;
        const QString wrong = wrongAfter(rig, next.bagLengthUm, productMm);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("pair %1: %2").arg(i).arg(wrong)));
    }
    std::ranges::sort(times);
    qInfo("%d pairs, %d beyond a limit: largest step of the knife %.3f and of the infeed %.3f of its limit, "
          "of the "
          "film %.1f Hz; time median %.2f s, largest %.2f s",
          pairs, broken, largest.knife, largest.infeed, largest.film, times[times.size() / 2], times.back());
    QCOMPARE(broken, 0);
}

CAMPANEL_TEST(TestProgramChange)

} // namespace test_program_change

#include "test_program_change.moc"
