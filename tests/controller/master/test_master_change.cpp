// SPDX-License-Identifier: Apache-2.0
// The change of program while an encoder leads: over the boundary where no axis steps too far at the line's
// speed, by the clutch where one would. The run goes on, and nothing is lost.
#include "change_bench.h"

#include "engine/ctl_cam.h"
#include "master/ctl_gear.h"
#include "motion/ctl_motion.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace test_master_change {

using namespace campanel::test;
using namespace campanel::test::change;

namespace {

constexpr double filmPulsesPerMm = 10'000.0 / 150.0;
constexpr double flightPulses = 20'000.0;

double lengthMm(const BankImage& bank)
{
    return bank.bagLengthUm / 1000.0;
}

double fullMmPerS(const BankImage& bank)
{
    return lengthMm(bank) * clockHz / bank.cycleTicks();
}

// Returns the pulses of the knife for a mm of film at one end of the cycle.
double knifePerMm(const BankImage& bank, bool atEnd)
{
    const BankRow& row = atEnd ? bank.rows.back() : bank.rows.front();
    return static_cast<double>(row.pulses) / row.ticks * bank.cycleTicks() / lengthMm(bank);
}

MachineOptions onLine(double mmPerS, std::uint32_t counts = 10'000)
{
    MachineOptions options = calm();
    options.shaft.counts = counts;
    options.shaft.speedMmPerS = mmPerS;
    return options;
}

void followEncoder(Rig& rig, const Registers& image)
{
    rig.install(image);
    const auto counts = static_cast<std::uint16_t>(rig.controller().machine().shaft().options().counts);
    QCOMPARE(rig.write(CTL_REG_MASTER_COUNTS, {0, counts}), 0);
    rig.setParameter(CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    rig.run(second / 2);
    rig.start();
    for (int i = 0; i < 1000 && rig.core().master.clutch.state != CTL_CLUTCH_ON; ++i)
        rig.run(10'000);
    QCOMPARE(rig.core().master.clutch.state, CTL_CLUTCH_ON);
}

struct Change {
    bool isTakenOver = false;
    bool rested = false;     // by its clutch
    bool kept = true;        // the run went on
    double lineMmPerS = 0.0; // where it was taken over
    double awayPulses = 0.0; // the farthest that the film was from the line, without a rest
    double timeS = 0.0;
    bool isThroughProduct = false;
};

// Runs the rig until the armed program has taken over and follows the encoder.
Change follow(Rig& rig)
{
    const std::uint32_t generation = rig.core().banks.generation;
    auto& shaft = rig.controller().machine().shaft();
    const auto away = [&] {
        return static_cast<double>(rig.core().packer.film_at) / 256.0 - shaft.positionMm() * filmPulsesPerMm;
    };
    const double before = away();
    Change change;
    int behind = 0;
    while (behind < 2000 && change.timeS < 120.0) {
        rig.controller().step();
        change.timeS += 250e-6;
        change.isThroughProduct =
            change.isThroughProduct || (rig.controller().cut() && rig.controller().cut()->throughProduct);
        change.kept = change.kept && rig.core().motion.state == CTL_STATE_RUNNING;
        change.rested = change.rested || rig.core().master.clutch.state != CTL_CLUTCH_ON;
        if (!change.isTakenOver && rig.core().banks.generation != generation) {
            change.isTakenOver = true;
            change.lineMmPerS = shaft.speedMmPerS();
        }
        if (!change.rested && behind < 20) // later it may be brought to its marks
            change.awayPulses = std::max(change.awayPulses, std::abs(away() - before));
        behind += change.isTakenOver && rig.core().master.clutch.state == CTL_CLUTCH_ON ? 1 : 0;
    }
    return change;
}

} // namespace

class TestMasterChange : public QObject {
    Q_OBJECT

private slots:
    void aGearGoesOnWhereItIs();
    void aThousandChangesOfACamLoseNoCount();
    void aCamThatGoesBackChangesWhereItIsForward();
    void goesOverTheBoundaryWhereItMay();
    void restsWhereAnAxisWouldStepTooFar();
    void aProductUnderTheFirstCutIsNotCut();
    void aStopInTheMiddleTakesOverAtStandstill_data();
    void aStopInTheMiddleTakesOverAtStandstill();
    void cancelInTheMiddleEngagesAgain();
    void aLineThatStandsInTheMiddleGoesOn();
    void aLineThatIsTooFastIsRefused();
    void aLineThatBecomesTooFastWaits();
    void randomPairsKeepTheirSteps();
};

// The position behind the change, against fractions of whole numbers.
void TestMasterChange::aGearGoesOnWhereItIs()
{
    std::mt19937_64 random(5);
    const auto pick = [&](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(random);
    };
    for (int i = 0; i < 10'000; ++i) {
        const std::int64_t count = pick(-1'000'000, 1'000'000);
        const std::array<std::int64_t, 2> n{pick(1'000'000, 2'000'000'000'000),
                                            pick(1'000'000, 2'000'000'000'000)};
        const std::array<std::int64_t, 2> d{pick(100'000, 1'000'000'000), pick(100'000, 1'000'000'000)};
        if (n[0] / d[0] < 20 || n[1] / d[1] < 20)
            continue;
        ctl_gear gear{};
        ctl_gear_set(&gear, static_cast<std::uint64_t>(n[0]), static_cast<std::uint64_t>(d[0]), 0);
        const std::int64_t ticks = ctl_gear_ticks(&gear, count, 0);
        const auto perCount = [&](std::size_t which) {
            return static_cast<long double>(n.at(which)) / static_cast<long double>(d.at(which));
        };
        const std::int64_t boundary = ticks - pick(-10, 10) * n[0] / d[0] - pick(0, 100);
        // Counts behind the boundary, and the ticks of the other gear that they are.
        const long double counts = count - boundary / perCount(0);
        ctl_gear_change(&gear, static_cast<std::uint64_t>(n[1]), static_cast<std::uint64_t>(d[1]),
                        ticks - boundary);
        for (const std::int64_t way : {std::int64_t{0}, std::int64_t{1}, pick(-100'000, 100'000)}) {
            const std::int64_t got = ctl_gear_ticks(&gear, count + way, 0);
            const long double wanted = (counts + way) * perCount(1);
            const auto off = static_cast<double>(got - wanted);
            QVERIFY2(
                off <= 0.01 + static_cast<double>(perCount(1)) / 65536.0 &&
                    off >= -1.01 - static_cast<double>(perCount(1)) / 65536.0,
                qPrintable(
                    QStringLiteral("%1: %2 of %3").arg(i).arg(off).arg(static_cast<double>(perCount(1)))));
        }
    }
}

// Between two cams of 2000 counts a cycle at different rates: their cycles stay where the shaft has them.
void TestMasterChange::aThousandChangesOfACamLoseNoCount()
{
    constexpr std::array<std::uint32_t, 2> cycles{1'600'000, 1'233'933}; // at 60.0 and 77.8 r/min
    std::array<CamImage, 2> cams{sineCam(5000.0, 300.0, 400, cycles[0]),
                                 sineCam(5000.0, 200.0, 300, cycles[1])};
    cams[1].masterRate = 778;
    Rig rig(onLine(250.0));
    setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, 1'000'000);
    followEncoder(rig, cams[0].registers());
    const auto stand = [&] {
        rig.controller().machine().shaft().setSpeed(0.0);
        rig.run(2 * second);
        QVERIFY(ctl_tracker_stands(&rig.core().master.tracker));
    };
    stand();
    const std::int64_t counted = rig.core().master.tracker.count;
    const auto position = static_cast<std::int64_t>(rig.core().motion.table.cam.position);
    rig.controller().machine().shaft().setSpeed(250.0);
    constexpr int changes = 1000;
    for (int i = 1; i <= changes; ++i) {
        arm(rig, cams.at(static_cast<std::size_t>(i % 2)), static_cast<std::uint16_t>(i + 1));
        for (int j = 0; j < 4000 && rig.core().transfer.state == CTL_STAGED_STATE_ARMED; ++j)
            rig.controller().step();
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(ctl_bank_cycle_ticks(rig.core().motion.table.bank),
                 cycles.at(static_cast<std::size_t>(i % 2)));
    }
    stand();
    // Where it was, by the counts of a cycle, but for a rounding of 1/65536 count at each change.
    const std::int64_t way = (rig.core().master.tracker.count - counted) * cycles[0] / 2000;
    const std::int64_t off =
        (static_cast<std::int64_t>(rig.core().motion.table.cam.position) - position - way) % cycles[0];
    QVERIFY2(std::min(std::abs(off), cycles[0] - std::abs(off)) <= 3, qPrintable(QString::number(off)));
    const double turns = static_cast<double>(rig.core().motion.table.cam.position) / cycles[0];
    const double axis = 5000.0 * turns + 300.0 * std::sin(2.0 * std::numbers::pi * turns);
    const auto inCycle = static_cast<double>(rig.commanded() % 5000);
    QVERIFY2(std::abs(std::remainder(inCycle - axis, 5000.0)) < 1.0,
             qPrintable(QString::number(inCycle - axis)));
}

// The program is armed while the shaft creeps back.
void TestMasterChange::aCamThatGoesBackChangesWhereItIsForward()
{
    const CamImage one = sineCam(5000.0, 300.0, 400, 1'600'000);
    const CamImage other = sineCam(5000.0, 200.0, 300, 1'600'000);
    Rig rig(onLine(250.0));
    setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, 1'000'000);
    followEncoder(rig, one.registers());
    rig.controller().machine().shaft().setSpeed(-20.0);
    rig.run(2 * second);
    arm(rig, other, 2);
    rig.run(5 * second);
    QCOMPARE(rig.core().banks.generation, 1u);
    rig.controller().machine().shaft().setSpeed(250.0);
    rig.run(2 * second);
    QCOMPARE(rig.core().banks.generation, 2u);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded() % 5000, 0);
}

// 60 to 120 bags a minute of the same length: film and knife keep their speed.
void TestMasterChange::goesOverTheBoundaryWhereItMay()
{
    Rig rig(onLine(250.0));
    setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, 100);
    followEncoder(rig, cutter(250'000, 60).registers());
    rig.run(10 * second);
    arm(rig, cutter(250'000, 120), 2);
    const Change change = follow(rig);
    QVERIFY(change.isTakenOver && change.kept && !change.rested);
    QVERIFY2(change.awayPulses < 3.0, qPrintable(QString::number(change.awayPulses)));
    const QString wrong = wrongAfter(rig, 250'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestMasterChange::restsWhereAnAxisWouldStepTooFar()
{
    Rig rig(onLine(400.0));
    followEncoder(rig, cutter(250'000, 120).registers());
    rig.run(10 * second);
    arm(rig, cutter(400'000, 90), 2);
    const Change change = follow(rig);
    QVERIFY(change.isTakenOver && change.kept && change.rested);
    const QString wrong = wrongAfter(rig, 400'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

// Products 100 mm apart lie under every first cut of 400 mm, 200 mm behind the boundary.
void TestMasterChange::aProductUnderTheFirstCutIsNotCut()
{
    for (const std::uint32_t stepHz : {500u, 100'000u}) { // by the clutch, and over the boundary
        Rig rig(onLine(200.0));
        rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
        setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, stepHz);
        setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, 100'000);
        followEncoder(rig, cutter(100'000, 120).registers());
        rig.run(20 * second);
        const std::uint32_t skipped = rig.core().packer.skipped;
        arm(rig, cutter(400'000, 60), 2);
        const Change change = follow(rig);
        QVERIFY(change.isTakenOver && change.kept && !change.isThroughProduct);
        QCOMPARE(change.rested, stepHz == 500u);
        QVERIFY(rig.core().packer.skipped > skipped);
        const QString wrong = wrongAfter(rig, 400'000);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
}

namespace {

// Returns a running rig whose line has begun to leave its encoder for a change.
struct RestingRig : Rig {
    RestingRig()
        : Rig(onLine(400.0))
    {
        followEncoder(*this, cutter(250'000, 120).registers());
        run(10 * second);
        arm(*this, cutter(400'000, 90), 2);
        while (core().master.clutch.state != CTL_CLUTCH_DISENGAGING)
            controller().step();
    }
};

} // namespace

void TestMasterChange::aStopInTheMiddleTakesOverAtStandstill_data()
{
    QTest::addColumn<int>("code");
    QTest::newRow("at cycle end") << int{CTL_COMMAND_STOP_AT_CYCLE_END};
    QTest::newRow("at once") << int{CTL_COMMAND_STOP_NOW};
}

void TestMasterChange::aStopInTheMiddleTakesOverAtStandstill()
{
    QFETCH(int, code);
    RestingRig rig;
    QCOMPARE(rig.command(static_cast<std::uint16_t>(code)), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const bool isAtBoundary = code == CTL_COMMAND_STOP_AT_CYCLE_END;
    QCOMPARE(rig.core().banks.generation, isAtBoundary ? 2u : 1u);
    rig.run(5 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY); // it does not engage by itself
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    rig.run(15 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 2u);
    QCOMPARE(rig.core().master.clutch.state, CTL_CLUTCH_ON);
    const QString wrong = wrongAfter(rig, 400'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestMasterChange::cancelInTheMiddleEngagesAgain()
{
    RestingRig rig;
    const std::int64_t offset = rig.core().master.clutch.offset;
    QCOMPARE(rig.command(CTL_COMMAND_CANCEL_APPLY), CTL_REFUSAL_NONE);
    rig.run(10 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 1u);
    QCOMPARE(rig.core().master.clutch.state, CTL_CLUTCH_ON);
    QCOMPARE((rig.core().master.clutch.offset - offset) % 4'000'000, 0); // in phase
    const QString wrong = wrongAfter(rig, 250'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestMasterChange::aLineThatStandsInTheMiddleGoesOn()
{
    RestingRig rig;
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(5 * second);
    rig.controller().machine().shaft().setSpeed(-20.0);
    rig.run(second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    rig.controller().machine().shaft().setSpeed(400.0);
    rig.run(20 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 2u);
    const QString wrong = wrongAfter(rig, 400'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestMasterChange::aLineThatIsTooFastIsRefused()
{
    Rig rig(onLine(400.0));
    followEncoder(rig, cutter(250'000, 120).registers());
    const Registers image = cutter(250'000, 60).registers(); // of 250 mm/s
    QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_MASTER_TOO_FAST);
    rig.run(5 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 1u);
}

// It has become too fast since the program was armed.
void TestMasterChange::aLineThatBecomesTooFastWaits()
{
    Rig rig(onLine(240.0));
    followEncoder(rig, cutter(460'000, 60).registers());
    const std::int64_t cycles = rig.core().motion.cycle_count;
    while (rig.core().motion.cycle_count == cycles)
        rig.controller().step();
    arm(rig, cutter(250'000, 60), 2);
    rig.controller().machine().shaft().setSpeed(400.0);
    rig.run(10 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 1u);
    rig.controller().machine().shaft().setSpeed(240.0);
    rig.run(10 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.generation, 2u);
    const QString wrong = wrongAfter(rig, 250'000);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

void TestMasterChange::randomPairsKeepTheirSteps()
{
    const int pairs = std::max(15, qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES"));
    std::mt19937_64 random(19);
    int rested = 0;
    double largest = 0.0; // step over its limit
    double away = 0.0;
    std::vector<double> times;
    for (int i = 0; i < pairs; ++i) {
        const auto pick = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const auto knives = static_cast<std::uint16_t>(1 << random() % 3); // 1, 2 or 4
        const auto any = [&] {
            const double length = pick(0, 1) < 0.3 ? 250 : pick(100, 460);
            const double middle = pick(0.3, 0.7);
            const double half = pick(0.05, 0.2);
            return cutter(static_cast<std::uint32_t>(length * 1000),
                          pick(60, std::min(350.0, 60.0 * 700.0 / length)),
                          {middle - half, middle + half, pick(0.9, 1.1), pick(0, 0.6), knives});
        };
        const BankImage one = any();
        const BankImage next = any();
        const double fastest = std::min(fullMmPerS(one), fullMmPerS(next));
        MachineOptions options = onLine(i % 2 == 0 ? 0.98 * fastest : std::min(0.98 * fastest, lengthMm(one)),
                                        i % 4 < 2 ? 10'000 : 2500);
        options.shaft.ripple = i % 3 == 0 ? 0.01 : 0.0;
        options.products.lengthMm = pick(20, 60);
        options.products.missing = i % 3 == 0 ? pick(0, 1) : 0.0;
        options.seed = static_cast<std::uint64_t>(i) + 1;
        Rig rig(options);
        rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
        const double knifeLimit = std::round(pick(300, 20'000));
        const double infeedLimit = std::round(pick(300, 10'000));
        setLimit(rig, CTL_REG_PARAMETER_KNIFE_STEP, static_cast<std::uint32_t>(knifeLimit));
        setLimit(rig, CTL_REG_PARAMETER_INFEED_STEP, static_cast<std::uint32_t>(infeedLimit));
        followEncoder(rig, one.registers());
        rig.run(10 * second);
        arm(rig, next, 2);
        const Change change = follow(rig);
        QVERIFY2(change.isTakenOver && change.kept && !change.isThroughProduct,
                 qPrintable(QStringLiteral("pair %1: %2 %3 %4")
                                .arg(i)
                                .arg(change.isTakenOver)
                                .arg(change.kept)
                                .arg(change.isThroughProduct)));
        rested += change.rested ? 1 : 0;
        times.push_back(change.timeS);
        const double knife = std::abs(knifePerMm(next, false) - knifePerMm(one, true)) * change.lineMmPerS;
        const double infeed =
            std::abs(flightPulses / lengthMm(next) - flightPulses / lengthMm(one)) * change.lineMmPerS;
        if (!change.rested) {
            largest = std::max({largest, knife / knifeLimit, infeed / infeedLimit});
            away = std::max(away, change.awayPulses);
        } else { // it had to
            QVERIFY2(knife > 0.95 * knifeLimit || infeed > 0.95 * infeedLimit, QByteArray::number(i));
        }
        const QString wrong = wrongAfter(rig, next.bagLengthUm);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("pair %1: %2").arg(i).arg(wrong)));
    }
    std::ranges::sort(times);
    qInfo("%d pairs, %d by the clutch: largest step %.3f of its limit, film %.1f pulses off the line; time "
          "median "
          "%.2f s, largest %.2f s",
          pairs, rested, largest, away, times[times.size() / 2], times.back());
    QVERIFY(largest < 1.03); // the ripple
    QVERIFY(away < 25.0);    // three counts of 2500, and what follows the marks
    QVERIFY(rested > 0 && rested < pairs);
}

CAMPANEL_TEST(TestMasterChange)

} // namespace test_master_change

#include "test_master_change.moc"
