// SPDX-License-Identifier: Apache-2.0
// A line that is faster than its program allows: refused at Start, the end of a run, a fault.
#include "master_bench.h"

#include "tests/support/test_program.h"

#include <QTest>

namespace test_master_speed {

using namespace campanel::test;
using namespace campanel::test::master;

namespace {

bool hasWarning(Rig& rig)
{
    return (rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_MASTER_TOO_FAST) != 0;
}

} // namespace

class TestMasterSpeed : public QObject {
    Q_OBJECT

private slots:
    void aLineThatIsTooFastIsRefused();
    void aLineThatBecomesTooFastEndsTheRun();
    void aSpeedThatNoLineHasIsAFault();
    void aShortSliceMakesUpForOthers();
};

void TestMasterSpeed::aLineThatIsTooFastIsRefused()
{
    Rig rig(onLine(1.2 * fullMmPerS));
    followEncoder(rig);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_MASTER_TOO_FAST);
    QCOMPARE(rig.write(CTL_REG_MASTER_SPEED_MAX, {130}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
}

void TestMasterSpeed::aLineThatBecomesTooFastEndsTheRun()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    QVERIFY(!hasWarning(rig));
    rig.controller().machine().shaft().setSpeed(1.2 * fullMmPerS);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 10'000'000));
    QVERIFY(hasWarning(rig));
    QVERIFY(ctl_table_between_cycles(&rig.core().motion.table));
    rig.controller().machine().shaft().setSpeed(fullMmPerS);
    rig.run(2'000'000);
    rig.start();
    QVERIFY(!hasWarning(rig));
}

void TestMasterSpeed::aSpeedThatNoLineHasIsAFault()
{
    Bench bench(10'000);
    bench.engage();
    for (int i = 0; i < 1000; ++i)
        (void)bench.pass(500);
    QVERIFY(bench.master.fault == CTL_LOST_NONE);
    (void)bench.pass(3000);
    for (int i = 0; i < 10 && bench.master.fault == CTL_LOST_NONE; ++i)
        (void)bench.pass(3000);
    QVERIFY(bench.master.fault != CTL_LOST_NONE);

    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    const std::int64_t before = rig.core().motion.commanded;
    rig.core().board.port.master = [](void*, std::uint16_t, ctl_master_input* input) {
        *input = {1'000'000, 0, 0, 0};
    };
    QVERIFY(rig.runUntilState(CTL_STATE_FAULT, 10'000));
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 1u << CTL_FAULT_BIT_MASTER_SPEED);
    QVERIFY(rig.core().motion.commanded - before < knifePulses * 3 / 250); // 3 mm of film
}

// A slice without a reading, then one of 5 us with it: some counts more are no speed.
void TestMasterSpeed::aShortSliceMakesUpForOthers()
{
    for (const std::uint32_t wholeSliceUs : {CTL_SLICE_US, 1u}) {
        Bench bench(10'000);
        bench.board.config.slice_us = wholeSliceUs;
        bench.engage();
        for (int i = 0; i < 20'000; ++i)
            (void)bench.pass(10, 200);
        QVERIFY(bench.master.fault == CTL_LOST_NONE);
        bench.board.catching_up = true;
        (void)bench.pass(0, 195);
        bench.board.catching_up = false;
        (void)bench.pass(20, 5);
        QCOMPARE(bench.master.fault,
                 wholeSliceUs == CTL_SLICE_US ? CTL_LOST_NONE : CTL_FAULT_BIT_MASTER_SPEED);
    }
}

CAMPANEL_TEST(TestMasterSpeed)

} // namespace test_master_speed

#include "test_master_speed.moc"
