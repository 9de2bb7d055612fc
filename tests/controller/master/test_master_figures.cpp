// SPDX-License-Identifier: Apache-2.0
// The cost of a line that leads: no tick and no pulse in a million cycles, few marked bags; and its registers.
#include "master_bench.h"

#include "engine/ctl_cam.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace test_master_figures {

using namespace campanel::test;
using namespace campanel::test::master;
using campanel::controller::MachineOptions;

class TestMasterFigures : public QObject {
    Q_OBJECT

private slots:
    void aMillionCyclesLoseNoTick_data();
    void aMillionCyclesLoseNoTick();
    void aMillionCyclesOfACamLoseNoPulse();
    void bagsOfALineThatStopsInThemAreMarked();
    void aSlowWaveMarksNoGoodBag_data();
    void aSlowWaveMarksNoGoodBag();
    void machineDataSurvivesAPowerCut();
    void registersTellTheSpeed();
};

void TestMasterFigures::aMillionCyclesLoseNoTick_data()
{
    QTest::addColumn<int>("counts");
    QTest::newRow("10 000") << 10'000;
    QTest::newRow("9973, no whole number of ticks") << 9973;
    QTest::newRow("2500") << 2500;
}

// Forward with ways back in between: the ticks given are those of the counts, to the last one.
void TestMasterFigures::aMillionCyclesLoseNoTick()
{
    QFETCH(int, counts);
    Bench bench(static_cast<std::uint32_t>(counts));
    bench.engage();
    const std::int64_t step = counts / 20;
    for (int i = 0; i < 200; ++i)
        (void)bench.pass(step);
    bench.standStill();
    QCOMPARE(bench.master.clutch.state, CTL_CLUTCH_ON);
    std::int64_t given = 0;
    const std::int64_t counted = bench.counts;
    // The tracker overshot at the stop, and that has been given already.
    const std::int64_t ahead = bench.master.line - bench.master.wanted;
    const std::int64_t ticksBefore = bench.master.gear.ticks;
    constexpr std::int64_t cycles = 1'000'000;
    while (bench.counts - counted < cycles * counts) {
        for (int i = 0; i < 20; ++i)
            given += bench.pass(step);
        for (int i = 0; i < 3; ++i)
            given += bench.pass(-step / 3);
    }
    bench.standStill();
    for (int i = 0; i < 2000; ++i) // slowly, beyond the overshoot of a line that stops dead
        given += bench.pass(1);
    for (int i = 0; i < 200; ++i)
        given += bench.pass(0);
    const std::int64_t endAhead = bench.master.line - bench.master.wanted;
    const std::int64_t ticks = bench.counts * std::int64_t{cycleTicks} / counts;
    QCOMPARE(bench.master.gear.ticks, ticks); // by the whole numbers of this line
    QCOMPARE(given, ticks - ticksBefore + endAhead - ahead);
    QVERIFY(endAhead >= 0 && endAhead < 2 * std::int64_t{cycleTicks} / counts);
    QVERIFY(bench.master.fault == CTL_LOST_NONE);
}

// 20 times back and forth in each of them; the advance of a cycle has a fraction of a pulse.
void TestMasterFigures::aMillionCyclesOfACamLoseNoPulse()
{
    CamImage image = cam();
    image.remainder = 1;
    image.divisor = 3;
    image.rows = camRows(
        10, [](double x) { return (camNet + 1.0 / 3.0) * x; }, [](double) { return camNet + 1.0 / 3.0; });
    Bench bench(10'000, image.registers()); // 2000 counts a cycle
    bench.engage();
    ctl_cam cam{};
    ctl_cam_reset(&cam, &bench.bank, &bench.board.config);
    const auto turn = [&](std::int64_t counts) {
        const std::int32_t way = bench.pass(counts, 250'000);
        const std::int32_t direction = way < 0 ? -1 : 1;
        auto left = static_cast<std::uint32_t>(std::abs(way));
        while (left != 0) {
            if (!cam.in_cycle)
                ctl_cam_begin_cycle(&cam, direction);
            std::uint32_t used = left;
            ctl_cam_advance(&cam, direction, &used);
            left -= used;
        }
    };
    for (int i = 0; i < 300; ++i)
        turn(100);
    for (int i = 0; i < 300; ++i)
        turn(0);
    QCOMPARE(bench.master.clutch.state, CTL_CLUTCH_ON);
    constexpr std::int64_t cycles = 1'000'000;
    const std::int64_t line = bench.master.line;
    const std::int64_t slave = ctl_cam_target(&cam);
    const std::int64_t counted = bench.counts;
    for (std::int64_t i = 0; i < cycles; ++i) {
        for (const std::int64_t counts : {900, -700, 900, 900, -300, 300})
            turn(counts);
    }
    for (int i = 0; i < 300; ++i)
        turn(0);
    QCOMPARE(bench.counts - counted, cycles * 2000);
    QCOMPARE(bench.master.line - line, cycles * cycleTicks);
    // The same angle, 10^6 cycles of 5000 1/3 pulses later: to a 256th.
    QVERIFY(std::abs(ctl_cam_target(&cam) - slave - (cycles * 15'001 * 256 / 3)) <= 1);
    for (std::int64_t i = 0; i < cycles; ++i)
        turn(-2000);
    for (int i = 0; i < 300; ++i)
        turn(0);
    QCOMPARE(bench.counts, counted);
    QCOMPARE(bench.master.line, line);
    QCOMPARE(ctl_cam_target(&cam), slave);
}

// Nothing but the bags around the standstill is off, and they are marked.
void TestMasterFigures::bagsOfALineThatStopsInThemAreMarked()
{
    constexpr unsigned startUp = 1u << CTL_BAG_BIT_START_UP;
    Rig rig(onLine(0.5 * fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.run(20 * cycleUs);
    int bags = 0;
    int marked = 0;
    double farthestMm = 0.0;
    for (int stop = 0; stop < 10; ++stop) {
        auto& shaft = rig.controller().machine().shaft();
        shaft.setSpeed(0.0);
        for (int i = 0; i < 4 * (8000 + 140 * stop); ++i) { // 250 us
            if (i == 12'000)
                shaft.setSpeed(0.5 * fullMmPerS);
            rig.controller().step();
            if (!rig.controller().cut())
                continue;
            const ctl_packer& packer = rig.core().packer;
            const bool isMarked =
                (packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3u] & startUp) != 0;
            ++bags;
            marked += isMarked ? 1 : 0;
            if (!isMarked)
                farthestMm = std::max(
                    farthestMm, std::abs(rig.controller().cut()->lengthUm.value_or(0) / 1000.0 - 250.0));
        }
    }
    QVERIFY(bags > 80);
    QVERIFY2(marked <= 30, qPrintable(QString::number(marked)));
    QVERIFY2(farthestMm < 0.2, qPrintable(QString::number(farthestMm)));
}

void TestMasterFigures::aSlowWaveMarksNoGoodBag_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("wave");
    QTest::newRow("20 % over 10 s") << 1.0 << 0.2;
    QTest::newRow("a line at 15 % of the rate") << 0.15 << 0.0;
}

// Bags of 460 mm at 300 a minute: the drives lag by 3 mm more at the knife than at the film.
void TestMasterFigures::aSlowWaveMarksNoGoodBag()
{
    QFETCH(double, share);
    QFETCH(double, wave);
    constexpr unsigned startUp = 1u << CTL_BAG_BIT_START_UP;
    BankImage bank = cutter();
    bank.bagLengthUm = 460'000;
    MachineOptions options = onLine(share * 2300.0);
    options.shaft.wave = wave;
    Rig rig(options);
    rig.install(bank);
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER}), 0);
    QCOMPARE(rig.write(CTL_REG_MASTER_SPEED_MAX, {130}), 0);
    rig.run(500'000);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    int marked = 0;
    double farthestMm = 0.0;
    for (int bags = 0; bags < 120;) {
        rig.controller().step();
        if (!rig.controller().cut() || !rig.controller().cut()->lengthUm)
            continue;
        ++bags;
        const ctl_packer& packer = rig.core().packer;
        const bool isMarked =
            (packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3u] & startUp) != 0;
        marked += isMarked ? 1 : 0;
        if (!isMarked)
            farthestMm = std::max(farthestMm, std::abs(*rig.controller().cut()->lengthUm / 1000.0 - 460.0));
    }
    QVERIFY2(marked <= 5, qPrintable(QString::number(marked)));
    QVERIFY2(farthestMm < 0.2, qPrintable(QString::number(farthestMm)));
}

void TestMasterFigures::machineDataSurvivesAPowerCut()
{
    MemoryFlash flash;
    {
        Rig rig({}, &flash);
        rig.install(cutter());
        QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE,
                           {1, 1, 1, 0, 0, 1234, 0, 5678, 1500, 2500, 75, 120, 0, 1, 3, 250, 9000}),
                 0);
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(cutter().registers())), CTL_REFUSAL_NONE);
        QCOMPARE(rig.write(CTL_REG_MASTER_ENGAGE, {100}), 0); // not saved
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.read(CTL_REG_MASTER_SOURCE, CTL_GROUP_MASTER),
             (Registers{1, 1, 1, 0, 0, 1234, 0, 5678, 1500, 2500, 75, 120, 0, 1, 3, 250, 9000}));
}

void TestMasterFigures::registersTellTheSpeed()
{
    Rig rig(onLine(500.0));
    followEncoder(rig);
    QCOMPARE(rig.status(CTL_REG_MASTER_STATUS_AVAILABLE), 1);
    QVERIFY(std::abs(rig.signedWide(CTL_REG_MASTER_STATUS_SPEED) - 500'000) < 5000);
    const std::int64_t counts = rig.signedWide(CTL_REG_MASTER_STATUS_COUNTS);
    const std::int64_t later = rig.core().master.tracker.count;
    QVERIFY(counts > 10'000 && counts <= later && later - counts < 20); // the answer takes its time
    // Led by a slice and what a person has entered.
    QVERIFY(std::abs(rig.read(CTL_REG_MASTER_STATUS_LEAD, 1).at(0) - 125) <= 2);
    QCOMPARE(rig.write(CTL_REG_MASTER_DELAY, {5000}), 0);
    rig.run(10'000);
    QVERIFY(std::abs(rig.read(CTL_REG_MASTER_STATUS_LEAD, 1).at(0) - 2625) <= 27);
}

CAMPANEL_TEST(TestMasterFigures)

} // namespace test_master_figures

#include "test_master_figures.moc"
