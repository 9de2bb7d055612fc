// SPDX-License-Identifier: Apache-2.0
// A packing machine that follows the encoder of a line: what it refuses, how it engages and disengages, and
// that no pulse is lost or given twice.
#include "rig.h"

#include "engine/ctl_cam.h"

#include "master/ctl_master.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace test_master_line {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr double fullMmPerS = 1250.0;
constexpr std::int64_t knifePulses = 10'000; // a cycle

BankImage cutter()
{
    BankImage bank = camBank(static_cast<std::uint32_t>(knifePulses), 1, cycleTicks);
    bank.bagLengthUm = 250'000;
    return bank;
}

// A cam of 0.2 revolutions of its master: 2000 counts, 0.2 s at 60 r/min.
constexpr double camNet = 5000.0; // pulses a cycle
constexpr double camSwing = 300.0;
constexpr double camMmPerS = 250.0;

CamImage cam()
{
    CamImage image = sineCam(camNet, camSwing, 400, cycleTicks);
    image.masterRampMs = 0;
    return image;
}

MachineOptions onLine(double mmPerS, std::uint32_t counts = 10'000)
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.shaft.counts = counts;
    options.shaft.speedMmPerS = mmPerS;
    return options;
}

void followEncoder(Rig& rig)
{
    rig.install(cutter());
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER}), 0);
    rig.run(500'000); // it measures the speed
}

std::uint16_t state(Rig& rig)
{
    return rig.status(CTL_REG_MASTER_STATUS_STATE);
}

bool runUntilEngaged(Rig& rig)
{
    for (int i = 0; i < 2000 && state(rig) != CTL_MASTER_STATE_ENGAGED; ++i)
        rig.run(10'000);
    return state(rig) == CTL_MASTER_STATE_ENGAGED;
}

bool hasWarning(Rig& rig)
{
    return (rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_MASTER_TOO_FAST) != 0;
}

// An encoder whose counts a test sets, and a master that reads them, without a machine.
struct Bench {
    std::int64_t counts = 0;
    std::uint16_t settings[CTL_GROUP_MASTER]{};
    ctl_board board{};
    ctl_master master{};
    ctl_ramp ramp{};
    Registers image;
    ctl_bank bank{};

    explicit Bench(std::uint32_t countsPerTurn, Registers registers = cutter().registers())
        : image(std::move(registers))
    {
        board.config = benchConfig();
        board.port.context = this;
        board.port.master = [](void* context, std::uint16_t, ctl_master_input* input) {
            *input = {static_cast<Bench*>(context)->counts, 0, 0, 0};
        };
        board.master = settings;
        settings[0] = CTL_MASTER_SOURCE_ENCODER;
        ctl_put32(&settings[CTL_REG_MASTER_COUNTS - CTL_REG_MASTER_SOURCE], countsPerTurn);
        ctl_put32(&settings[CTL_REG_MASTER_REVOLUTION - CTL_REG_MASTER_SOURCE], 250'000);
        settings[CTL_REG_MASTER_ENGAGE - CTL_REG_MASTER_SOURCE] = 50;
        settings[CTL_REG_MASTER_SPEED_MAX - CTL_REG_MASTER_SOURCE] = 150;
        settings[CTL_REG_MASTER_BACKWARD - CTL_REG_MASTER_SOURCE] = 1;
    }

    void engage()
    {
        std::ranges::copy(image, bank.registers);
        ctl_master_init(&master, &board);
        ctl_master_slice(&master);
        ctl_ramp_reset(&ramp, 6'400'000);
        ctl_master_engage(&master, &bank, 0, &ramp);
    }

    std::int32_t pass(std::int64_t by, std::uint32_t us = 10'000)
    {
        counts += by;
        board.now_us += us;
        ctl_master_slice(&master);
        return ctl_master_travel(&master, &ramp, us * 8);
    }

    void standStill()
    {
        for (int i = 0; i < 200; ++i)
            (void)pass(0);
    }
};

} // namespace

class TestMasterLine : public QObject {
    Q_OBJECT

private slots:
    void aControllerWithoutTheInputRefuses();
    void aCamThatCannotFollowIsRefused_data();
    void aCamThatCannotFollowIsRefused();
    void aCamFollowsForwardAndBack();
    void aCamMayWaitInstead();
    void aCamDisengagesAtTheEndOfACycle();
    void aMillionCyclesOfACamLoseNoPulse();
    void nothingMovesWithoutAStart();
    void engagesWhileTheLineRuns();
    void standsAndGoesOnWithTheLine();
    void waitsUntilTheLineHasComeBack();
    void disengagesAtTheEndOfACycle();
    void engagesAgainInPhase();
    void bagsOfALineThatStopsInThemAreMarked();
    void aSlowWaveMarksNoGoodBag_data();
    void aSlowWaveMarksNoGoodBag();
    void stopsWhereTheLineStands();
    void stopNowStopsAtOnce();
    void aLineThatIsTooFastIsRefused();
    void aLineThatBecomesTooFastEndsTheRun();
    void aSpeedThatNoLineHasIsAFault();
    void aRunKeepsItsMaster();
    void aMillionCyclesLoseNoTick_data();
    void aMillionCyclesLoseNoTick();
    void machineDataSurvivesAPowerCut();
    void registersTellTheSpeed();
};

void TestMasterLine::aControllerWithoutTheInputRefuses()
{
    Rig rig;
    rig.install(cutter());
    QCOMPARE(rig.status(CTL_REG_MASTER_STATUS_AVAILABLE), 0);
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NO_MASTER_INPUT);
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_CLOCK}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
}

void TestMasterLine::aCamThatCannotFollowIsRefused_data()
{
    QTest::addColumn<int>("rate");
    QTest::addColumn<int>("atEnd");
    QTest::addColumn<int>("refusal");
    QTest::newRow("forward") << 600 << int{CTL_END_BEHAVIOR_REPEAT} << int{CTL_REFUSAL_NONE};
    QTest::newRow("its master turns in reverse")
        << -600 << int{CTL_END_BEHAVIOR_REPEAT} << int{CTL_REFUSAL_CANNOT_FOLLOW_MASTER};
    QTest::newRow("once") << 600 << int{CTL_END_BEHAVIOR_STOP} << int{CTL_REFUSAL_CANNOT_FOLLOW_MASTER};
}

void TestMasterLine::aCamThatCannotFollowIsRefused()
{
    QFETCH(int, rate);
    QFETCH(int, atEnd);
    QFETCH(int, refusal);
    Rig rig(onLine(100.0));
    CamImage image = cam();
    image.masterRate = static_cast<std::int16_t>(rate);
    image.atEnd = static_cast<std::uint16_t>(atEnd);
    rig.install(image.registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(int{rig.command(CTL_COMMAND_START)}, refusal);
}

// The slave is where the curve is, also behind a way back, to a pulse.
void TestMasterLine::aCamFollowsForwardAndBack()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    auto& shaft = rig.controller().machine().shaft();
    std::int64_t before = rig.core().motion.commanded;
    for (const double speed : {camMmPerS, -0.7 * camMmPerS, -0.9 * camMmPerS, 0.3 * camMmPerS}) {
        shaft.setSpeed(speed);
        rig.run(5'123'000);
        QVERIFY(speed > 0.0 ? rig.core().motion.commanded > before : rig.core().motion.commanded < before);
        before = rig.core().motion.commanded;
        shaft.setSpeed(0.0);
        rig.run(2'000'000);
        const ctl_master& master = rig.core().master;
        QVERIFY(ctl_tracker_stands(&master.tracker));
        QCOMPARE(master.line, master.gear.ticks + master.clutch.offset);
        QCOMPARE(master.gear.ticks % 800, 0); // 2000 counts a cycle of 1 600 000 ticks
        const double cycles = static_cast<double>(master.line) / cycleTicks;
        const double slave = camNet * cycles + camSwing * std::sin(2.0 * std::numbers::pi * cycles);
        QVERIFY(std::abs(static_cast<double>(rig.commanded()) - slave) < 1.0);
    }
}

void TestMasterLine::aCamMayWaitInstead()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.write(CTL_REG_MASTER_BACKWARD, {0});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(2'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    rig.controller().machine().shaft().setSpeed(-camMmPerS);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
}

void TestMasterLine::aCamDisengagesAtTheEndOfACycle()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    rig.run(1'234'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const std::int64_t cycles = rig.core().motion.cycle_count;
    QCOMPARE(rig.commanded(), static_cast<std::int64_t>(camNet) * cycles);
}

// 20 times back and forth in each of them; the advance of a cycle has a fraction of a pulse.
void TestMasterLine::aMillionCyclesOfACamLoseNoPulse()
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

// Neither at power-up with a running line nor behind a fault.
void TestMasterLine::nothingMovesWithoutAStart()
{
    MemoryFlash flash;
    {
        Rig rig(onLine(fullMmPerS), &flash);
        followEncoder(rig);
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(cutter().registers())), CTL_REFUSAL_NONE);
    }
    Rig rig(onLine(fullMmPerS), &flash);
    QCOMPARE(rig.status(CTL_REG_MASTER_SOURCE), CTL_MASTER_SOURCE_ENCODER);
    rig.run(5'000'000);
    QVERIFY(rig.core().master.tracker.count > 200'000);
    QCOMPARE(rig.core().motion.commanded, 0);
    QCOMPARE(rig.core().packer.film_sent, 0);
}

void TestMasterLine::engagesWhileTheLineRuns()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGING);
    QVERIFY(rig.statusWide(CTL_REG_MASTER_STATUS_TO_ENGAGED) >
            60'000); // um; the ramp needs the time it needs
    // The film gains no more speed in a slice than the ramp of the clock would, times one and a half.
    const double perSlice = static_cast<double>(rig.core().packer.bag) / 800.0;
    const double most = 1.5 * perSlice / 3200.0;
    double last = 0.0;
    std::int64_t before = rig.core().packer.film_at;
    while (state(rig) == CTL_MASTER_STATE_ENGAGING) {
        const std::int64_t start = before;
        for (int i = 0; i < 40; ++i)
            rig.controller().step();
        before = rig.core().packer.film_at;
        const double speed = static_cast<double>(before - start) / 40.0;
        QVERIFY2(speed - last < 40.0 * most * 1.1 + 0.05 * perSlice,
                 qPrintable(QString::number(speed - last)));
        last = speed;
    }
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.run(1'000'000);
    QVERIFY(std::abs(rig.status(CTL_REG_STATUS_MASTER_SPEED) - 10'000) < 100);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
}

void TestMasterLine::standsAndGoesOnWithTheLine()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    rig.run(4'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.controller().machine().shaft().setSpeed(fullMmPerS);
    rig.run(4'000'000);
    QVERIFY(rig.core().motion.commanded > stands + 5 * knifePulses);
}

void TestMasterLine::waitsUntilTheLineHasComeBack()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    auto& shaft = rig.controller().machine().shaft();
    shaft.setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    const std::int64_t film = rig.core().packer.film_sent;
    const std::int64_t counts = rig.core().master.tracker.count;
    shaft.setSpeed(-40.0);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
    QCOMPARE(rig.core().packer.film_sent, film);
    const double backMm = static_cast<double>(counts - rig.core().master.tracker.count) / 40.0;
    QVERIFY(backMm > 50.0);
    // It still has to come back so far, to the count.
    QVERIFY(std::abs(rig.read(CTL_REG_MASTER_STATUS_HELD, 1).at(0) - 32'767) < 1); // saturates
    shaft.setSpeed(40.0);
    while (rig.core().master.tracker.count < counts - 40) {
        rig.controller().step();
        QCOMPARE(rig.core().motion.commanded, stands);
    }
    rig.run(500'000);
    QVERIFY(rig.core().motion.commanded > stands);
    // Line and counts are where they would be without the way back.
    shaft.setSpeed(0.0);
    rig.run(2'000'000);
    const ctl_master& master = rig.core().master;
    QVERIFY(std::abs(master.line - master.wanted) < 200); // an overshoot of the tracker's, below a count
}

void TestMasterLine::disengagesAtTheEndOfACycle()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.run(3 * cycleUs + 41'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    std::int64_t last = rig.core().motion.commanded;
    while (rig.core().motion.state == CTL_STATE_STOPPING) {
        rig.controller().step();
        QVERIFY(rig.core().motion.commanded >= last);
        last = rig.core().motion.commanded;
    }
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    QVERIFY(ctl_table_between_cycles(&rig.core().motion.table));
    QCOMPARE(rig.core().packer.master, 0u);
    QCOMPARE(rig.commanded() % knifePulses, 0);
    QCOMPARE(state(rig), CTL_MASTER_STATE_OFF);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, last); // the line runs on
}

// Start and stop at any moment: a bag begins where bags began before, seen from the line's shaft.
void TestMasterLine::engagesAgainInPhase()
{
    Rig rig(onLine(fullMmPerS * 0.8));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    const std::int64_t offset = rig.core().master.clutch.offset;
    for (int i = 0; i < 20; ++i) {
        rig.run(100'000 + 37'000 * static_cast<std::uint64_t>(i));
        QCOMPARE(rig.command(i % 3 == 0 ? CTL_COMMAND_STOP_NOW : CTL_COMMAND_STOP_AT_CYCLE_END),
                 CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        rig.run(113'000 * static_cast<std::uint64_t>(i));
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QVERIFY(runUntilEngaged(rig));
        const std::int64_t moved = rig.core().master.clutch.offset - offset;
        QCOMPARE(moved % static_cast<std::int64_t>(cycleTicks), 0);
        QCOMPARE(rig.core().master.line % static_cast<std::int64_t>(cycleTicks),
                 static_cast<std::int64_t>(rig.core().packer.master));
    }
}

// Nothing but the bags around the standstill is off, and they are marked.
void TestMasterLine::bagsOfALineThatStopsInThemAreMarked()
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

void TestMasterLine::aSlowWaveMarksNoGoodBag_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("wave");
    QTest::newRow("20 % over 10 s") << 1.0 << 0.2;
    QTest::newRow("a line at 15 % of the rate") << 0.15 << 0.0;
}

// Bags of 460 mm at 300 a minute: the drives lag by 3 mm more at the knife than at the film.
void TestMasterLine::aSlowWaveMarksNoGoodBag()
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

// The end of the cycle may never come.
void TestMasterLine::stopsWhereTheLineStands()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 1'000'000));
    QCOMPARE(rig.core().motion.commanded, stands);
}

void TestMasterLine::stopNowStopsAtOnce()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.run(1'000'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 1'000'000)); // a ramp of 800 ms
}

void TestMasterLine::aLineThatIsTooFastIsRefused()
{
    Rig rig(onLine(1.2 * fullMmPerS));
    followEncoder(rig);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_MASTER_TOO_FAST);
    QCOMPARE(rig.write(CTL_REG_MASTER_SPEED_MAX, {130}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
}

void TestMasterLine::aLineThatBecomesTooFastEndsTheRun()
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

void TestMasterLine::aSpeedThatNoLineHasIsAFault()
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

void TestMasterLine::aRunKeepsItsMaster()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_CLOCK}), 0);
    QCOMPARE(rig.write(CTL_REG_MASTER_REVERSED, {1}), 0);
    rig.run(2'000'000);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(1000);
    QVERIFY(!rig.core().master.reads);
}

void TestMasterLine::aMillionCyclesLoseNoTick_data()
{
    QTest::addColumn<int>("counts");
    QTest::newRow("10 000") << 10'000;
    QTest::newRow("9973, no whole number of ticks") << 9973;
    QTest::newRow("2500") << 2500;
}

// Forward with ways back in between: the ticks given are those of the counts, to the last one.
void TestMasterLine::aMillionCyclesLoseNoTick()
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

void TestMasterLine::machineDataSurvivesAPowerCut()
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

void TestMasterLine::registersTellTheSpeed()
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

CAMPANEL_TEST(TestMasterLine)

} // namespace test_master_line

#include "test_master_line.moc"
