// SPDX-License-Identifier: Apache-2.0
// The operator's hand on the speed: slower and faster by the ramp while the machine runs, every bag as good
// as at full speed.
#include "rig.h"

#include "tests/support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdlib>
#include <random>

namespace test_hand_speed {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t second = 1'000'000;
constexpr int illegalValue = 3;

class Line : public Rig {
public:
    explicit Line(const MachineOptions& options = {})
        : Rig(options)
    {
        BankImage bank = camBank(10000, 1, cycleTicks);
        bank.bagLengthUm = 250'000;
        install(bank);
        start();
        run(10 * second);
    }

    int setSpeed(std::uint16_t percent) { return write(CTL_REG_HAND_SPEED, {percent}); }
    double speedPercent() { return status(CTL_REG_STATUS_MASTER_SPEED) / 100.0; }
    // Looks at the bags of this time; returns how many there are.
    int bags(std::uint64_t timeUs)
    {
        int count = 0;
        const std::uint64_t untilUs = controller().nowUs() + timeUs;
        while (controller().nowUs() < untilUs) {
            controller().step();
            const auto& cut = controller().cut();
            if (!cut || !cut->lengthUm)
                continue;
            ++count;
            isGood = isGood && ctl_packer_bag_class(&core().packer) == CTL_BAG_GOOD;
            largestMm = std::max(largestMm, std::abs(*cut->lengthUm / 1000.0 - 250.0));
            largestMarkMm = std::max(largestMarkMm, std::abs(cut->markErrorMm));
        }
        return count;
    }
    double largestMm = 0.0;
    double largestMarkMm = 0.0;
    bool isGood = true;
};

} // namespace

class TestHandSpeed : public QObject {
    Q_OBJECT

private slots:
    void machineFollowsTheHand();
    void bagsAreGoodWhileItChanges();
    void theRampIsKept();
    void aStopLandsOnTheBoundary();
    void itHoldsForTheNextRunAndProgram();
    void wrongSpeedsAreRefused();
    void camsFollowToo();
};

void TestHandSpeed::machineFollowsTheHand()
{
    Line line;
    for (const std::uint16_t percent :
         {std::uint16_t{60}, std::uint16_t{20}, std::uint16_t{95}, std::uint16_t{100}}) {
        QCOMPARE(line.setSpeed(percent), 0);
        line.run(5 * second);
        QVERIFY(std::abs(line.speedPercent() - percent) < 0.02);
        const int bags = line.bags(60 * second);
        QVERIFY2(std::abs(bags - 3 * percent) <= 1, qPrintable(QString::number(bags)));
    }
}

void TestHandSpeed::bagsAreGoodWhileItChanges()
{
    Line even;
    even.bags(200 * second);
    Line changed;
    std::mt19937_64 random(5);
    for (int i = 0; i < 150; ++i) {
        changed.setSpeed(static_cast<std::uint16_t>(20 + random() % 81));
        changed.bags(random() % (3 * second));
    }
    QVERIFY(changed.isGood);
    QVERIFY2(changed.largestMm < 0.2, qPrintable(QString::number(changed.largestMm)));
    QVERIFY2(
        changed.largestMarkMm < even.largestMarkMm + 0.1,
        qPrintable(
            QStringLiteral("%1, without changes %2").arg(changed.largestMarkMm).arg(even.largestMarkMm)));
}

void TestHandSpeed::theRampIsKept()
{
    Line line;
    line.setSpeed(40);
    line.run(5 * second);
    // The parameter is the time from standstill to full speed: 60 % of it in 60 % of that time.
    const double rampS =
        line.core().board.parameter[CTL_REG_PARAMETER_RAMP_TIME - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT] /
        1000.0;
    line.setSpeed(100);
    const std::uint64_t fromUs = line.controller().nowUs();
    while (ctl_motion_master_speed(&line.core().motion) < 10000)
        line.controller().step();
    const double tookS = static_cast<double>(line.controller().nowUs() - fromUs) / 1e6;
    // It waits for the end of a sealing window, if there is one.
    QVERIFY2(tookS > 0.6 * rampS - 0.01 && tookS < 0.6 * rampS + 0.4, qPrintable(QString::number(tookS)));
}

void TestHandSpeed::aStopLandsOnTheBoundary()
{
    Line line;
    std::mt19937_64 random(7);
    for (int i = 0; i < 20; ++i) {
        line.setSpeed(static_cast<std::uint16_t>(20 + random() % 81));
        line.bags(random() % (2 * second));
        QCOMPARE(line.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
        line.setSpeed(static_cast<std::uint16_t>(20 + random() % 81)); // also while it stops
        QVERIFY(line.runUntilState(CTL_STATE_READY));
        QCOMPARE(line.core().packer.master, 0u);
        QCOMPARE(line.core().packer.film.phase, 0u);
        QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        line.bags(2 * second);
    }
    QVERIFY(line.isGood);
    QVERIFY2(line.largestMm < 0.2, qPrintable(QString::number(line.largestMm)));
}

void TestHandSpeed::itHoldsForTheNextRunAndProgram()
{
    Line line;
    line.setSpeed(50);
    BankImage bank = camBank(10000, 1, 2 * cycleTicks);
    bank.bagLengthUm = 250'000;
    QCOMPARE(line.download(bank.registers(), 9), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(line.apply(bank.registers(), CTL_APPLY_MODE_NEXT_CYCLE, 9), CTL_REFUSAL_NONE);
    const std::uint32_t generation = line.core().banks.generation;
    for (int i = 0; i < 200 && line.core().banks.generation == generation; ++i)
        line.run(100'000);
    QCOMPARE(line.core().banks.generation, generation + 1);
    line.run(10 * second);
    QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
    QVERIFY(std::abs(line.speedPercent() - 50.0) < 0.02);
    line.command(CTL_COMMAND_STOP_NOW);
    QVERIFY(line.runUntilState(CTL_STATE_READY));
    line.start();
    line.run(5 * second);
    QVERIFY(std::abs(line.speedPercent() - 50.0) < 0.02);
    line.controller().restart();
    QCOMPARE(line.status(CTL_REG_HAND_SPEED), 100);
}

void TestHandSpeed::wrongSpeedsAreRefused()
{
    Line line;
    for (const std::uint16_t percent :
         {std::uint16_t{0}, std::uint16_t{19}, std::uint16_t{101}, std::uint16_t{65535}})
        QCOMPARE(line.setSpeed(percent), illegalValue);
    QCOMPARE(line.status(CTL_REG_HAND_SPEED), 100);
    line.run(second);
    QCOMPARE(line.speedPercent(), 100.0);
}

void TestHandSpeed::camsFollowToo()
{
    for (const unsigned shape : {CTL_RAMP_SHAPE_TRAPEZOID, CTL_RAMP_SHAPE_SCURVE}) {
        CamImage cam = sineCam(10000, 500, 180, 8'000'000);
        cam.masterRampMs = 400;
        cam.rampShape = static_cast<std::uint16_t>(shape);
        Rig rig;
        rig.install(cam.registers());
        rig.start();
        for (const std::uint16_t percent : {std::uint16_t{100}, std::uint16_t{30}, std::uint16_t{75}}) {
            QCOMPARE(rig.write(CTL_REG_HAND_SPEED, {percent}), 0);
            rig.run(2 * second);
            QVERIFY2(std::abs(rig.status(CTL_REG_STATUS_MASTER_SPEED) / 100.0 - percent) < 0.02,
                     qPrintable(QString::number(rig.status(CTL_REG_STATUS_MASTER_SPEED))));
            const std::uint32_t cycles = rig.core().motion.cycle_count;
            rig.run(60 * second);
            const double wanted = 60.0 * 8e6 / cam.cycleTicks * percent / 100.0;
            QVERIFY(std::abs(rig.core().motion.cycle_count - cycles - wanted) <= 1.0);
        }
        rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        QCOMPARE(ctl_motion_master_angle(&rig.core().motion), 0);
    }
}

CAMPANEL_TEST(TestHandSpeed)

} // namespace test_hand_speed

#include "test_hand_speed.moc"
