// SPDX-License-Identifier: Apache-2.0
// The order that the controller counts: each bag once, by what became of it; the end of the run with it; what
// a power cut leaves. Who counts beside it looks at the records of the bags and at the jaws alone.
#include "rig.h"

#include "base/ctl_words.h"
#include "tests/support/interval_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cstdlib>
#include <random>

namespace test_order {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t clockHz = 8'000'000;
constexpr std::uint16_t number = 7;

struct Counts {
    std::uint32_t good = 0;
    std::uint32_t rejected = 0;
    std::uint32_t empty = 0;
    std::uint32_t cut = 0;

    bool operator==(const Counts&) const = default;
};

// Returns a machine whose bags are good from the first one in register on.
MachineOptions calm()
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.products.scatterMm = 0.0;
    return options;
}

enum class Leader { Clock, Shaft, Wheel };

MachineOptions ledBy(Leader leader, MachineOptions options)
{
    if (leader != Leader::Clock)
        options.shaft.counts = 10'000;
    options.shaft.drivesFilm = leader == Leader::Wheel;
    return options;
}

class Line : public Rig {
public:
    explicit Line(const MachineOptions& options = calm(), double bagsPerMin = 300.0,
                  Leader leader = Leader::Clock, MemoryFlash* flash = nullptr)
        : Rig(ledBy(leader, options), flash)
    {
        installFor(bagsPerMin);
        if (leader == Leader::Clock)
            return;
        write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        write(CTL_REG_MASTER_PLACE,
              {static_cast<std::uint16_t>(leader == Leader::Wheel ? CTL_MASTER_PLACE_WHEEL
                                                                  : CTL_MASTER_PLACE_SHAFT)});
        controller().machine().shaft().setSpeed(bagsPerMin / 60.0 * 250.0);
        run(2'000'000);
    }

    void installFor(double bagsPerMin)
    {
        BankImage bank = camBank(10000, 1, static_cast<std::uint32_t>(clockHz * 60.0 / bagsPerMin));
        bank.bagLengthUm = 250'000;
        install(bank);
    }
    std::uint16_t order(std::uint32_t quantity, std::uint16_t action = CTL_ORDER_ACTION_STOP,
                        std::uint16_t orderNumber = number)
    {
        return command(CTL_COMMAND_ORDER_START, orderNumber, action, quantity);
    }
    // What the registers say, without the time that the line takes.
    std::uint16_t value(std::uint16_t address)
    {
        std::array<std::uint16_t, CTL_GROUP_ORDER_STATUS> group{};
        ctl_order_registers(&core().order, group.data());
        return group.at(address - CTL_REG_ORDER_STATUS_STATE);
    }
    std::uint32_t wide(std::uint16_t address)
    {
        return std::uint32_t{value(address)} << 16 | value(static_cast<std::uint16_t>(address + 1));
    }
    std::uint16_t state() { return value(CTL_REG_ORDER_STATUS_STATE); }
    std::uint16_t onTheWay() { return value(CTL_REG_ORDER_STATUS_ON_THE_WAY); }
    Counts counts()
    {
        return {.good = wide(CTL_REG_ORDER_STATUS_GOOD),
                .rejected = wide(CTL_REG_ORDER_STATUS_REJECTED),
                .empty = wide(CTL_REG_ORDER_STATUS_EMPTY),
                .cut = wide(CTL_REG_ORDER_STATUS_CUT)};
    }
    bool sumHolds()
    {
        const Counts now = counts();
        return now.good + now.rejected + now.empty + onTheWay() == now.cut;
    }
    unsigned flagsOfNewest()
    {
        const ctl_packer& packer = core().packer;
        return packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3];
    }
    // Steps; counts a bag that is cut, by its record.
    void stepAndSee()
    {
        const std::uint32_t before = core().packer.bags;
        const bool isCounted = core().order.state == CTL_ORDER_STATE_ACTIVE;
        controller().step();
        if (core().packer.bags == before)
            return;
        physical += 1;
        if (!isCounted)
            return;
        constexpr unsigned bad = 1u << CTL_BAG_BIT_PRODUCT_ACROSS | 1u << CTL_BAG_BIT_CHANGE_OVER |
                                 1u << CTL_BAG_BIT_START_UP | 1u << CTL_BAG_BIT_BURNED |
                                 1u << CTL_BAG_BIT_JAMMED;
        const unsigned flags = flagsOfNewest();
        seen.cut += 1;
        if ((flags & bad) != 0 || (flags & 1u << CTL_BAG_BIT_TRACKED) == 0)
            seen.rejected += 1;
        else if ((flags & 1u << CTL_BAG_BIT_EMPTY) != 0)
            seen.empty += 1;
        else
            seen.good += 1;
    }
    // Runs until the machine stands, or so long; returns whether the sum held in each slice.
    bool runAndSee(std::uint64_t timeUs, bool untilStandstill = true)
    {
        const std::uint64_t untilUs = controller().nowUs() + timeUs;
        bool holds = true;
        while (controller().nowUs() < untilUs &&
               !(untilStandstill && core().motion.state == CTL_STATE_READY)) {
            stepAndSee();
            holds = holds && sumHolds();
        }
        return holds;
    }
    Counts seen;
    std::uint32_t physical = 0;
};

// For the message of a comparison that fails.
char* toString(const Counts& counts)
{
    return QTest::toString(QStringLiteral("%1 good, %2 rejected, %3 empty of %4")
                               .arg(counts.good)
                               .arg(counts.rejected)
                               .arg(counts.empty)
                               .arg(counts.cut));
}

} // namespace

class TestOrder : public QObject {
    Q_OBJECT

private slots:
    void countsEachBagOnce();
    void runEndsWithTheOrder_data();
    void runEndsWithTheOrder();
    void missingBagsAreMadeUp();
    void aRunGoesOnWithoutStop();
    void changesAndEnds();
    void wrongOrdersAreRefused();
    void powerCutKeepsTheCount();
    void withoutARecordItSaysSo();
    void recordOfAnotherVersionIsNone();
    void bagSpoiledBehindItsCutIsRejected();
    void randomOrdersEndAtTheirQuantity();
};

void TestOrder::countsEachBagOnce()
{
    MachineOptions options;
    options.products.missing = 0.1;
    options.products.misplaced = 0.1;
    Line line(options);
    QCOMPARE(line.order(1'000'000), CTL_REFUSAL_NONE);
    line.start();
    QVERIFY(line.runAndSee(60'000'000, false));
    line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(line.runAndSee(10'000'000));
    line.run(100'000);
    QVERIFY(line.seen.good > 150);
    QVERIFY(line.seen.rejected > 10);
    QVERIFY(line.seen.empty > 5);
    QCOMPARE(line.counts(), line.seen);
    QCOMPARE(line.onTheWay(), 0);
    // And so does the line.
    QCOMPARE(line.statusWide(CTL_REG_ORDER_STATUS_GOOD), line.seen.good);
    QCOMPARE(line.statusWide(CTL_REG_ORDER_STATUS_CUT), line.seen.cut);
}

void TestOrder::runEndsWithTheOrder_data()
{
    QTest::addColumn<Leader>("leader");
    QTest::addColumn<double>("bagsPerMin");
    QTest::addColumn<std::uint16_t>("rampMs");
    QTest::newRow("short ramp") << Leader::Clock << 300.0 << std::uint16_t{100};
    QTest::newRow("long ramp") << Leader::Clock << 300.0 << std::uint16_t{3000};
    QTest::newRow("slow") << Leader::Clock << 60.0 << std::uint16_t{800};
    QTest::newRow("shaft") << Leader::Shaft << 120.0 << std::uint16_t{800};
    QTest::newRow("wheel") << Leader::Wheel << 60.0 << std::uint16_t{800};
}

void TestOrder::runEndsWithTheOrder()
{
    QFETCH(Leader, leader);
    QFETCH(double, bagsPerMin);
    QFETCH(std::uint16_t, rampMs);
    Line line(calm(), bagsPerMin, leader);
    line.setParameter(CTL_REG_PARAMETER_RAMP_TIME, rampMs);
    line.start();
    QVERIFY(line.runAndSee(30'000'000, false)); // in register, without an order
    for (const std::uint32_t quantity : {1u, 2u, 3u, 7u, 25u, 60u}) {
        line.seen = {};
        // Each begins from standstill, but the first while the machine runs, behind a cut.
        for (const auto bags = line.core().packer.bags; quantity == 1 && line.core().packer.bags == bags;)
            line.controller().step();
        QCOMPARE(line.order(quantity, CTL_ORDER_ACTION_STOP, static_cast<std::uint16_t>(quantity)),
                 CTL_REFUSAL_NONE);
        line.physical = 0;
        // A run of two bags behind an encoder may make scrap of one of them: another start makes it up.
        for (int run = 0; run < 5 && line.state() == CTL_ORDER_STATE_ACTIVE; ++run) {
            if (quantity != 1 || run != 0) {
                QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
                QVERIFY(line.runUntilState(CTL_STATE_RUNNING));
            }
            QVERIFY(line.runAndSee(120'000'000));
            line.run(200'000);
        }
        QCOMPARE(line.state(), CTL_ORDER_STATE_COMPLETE);
        QCOMPARE(line.counts().good, quantity);
        QCOMPARE(line.counts(), line.seen);
        // An order that begins with fewer bags than the ramp takes has a surplus.
        if (quantity != 1)
            QCOMPARE(line.physical, line.seen.cut);
        if (leader != Leader::Wheel)
            QCOMPARE(line.core().packer.film.phase, 0u);
    }
}

void TestOrder::missingBagsAreMadeUp()
{
    MachineOptions options = calm();
    options.products.missing = 0.3;
    Line line(options);
    line.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 3000);
    int starts = 0;
    for (std::uint16_t order = 1; order <= 5; ++order) {
        line.seen = {};
        line.physical = 0;
        QCOMPARE(line.order(40, CTL_ORDER_ACTION_STOP, order), CTL_REFUSAL_NONE);
        while (line.state() != CTL_ORDER_STATE_COMPLETE && ++starts < 50) {
            QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
            QVERIFY(line.runUntilState(CTL_STATE_RUNNING));
            QVERIFY(line.runAndSee(120'000'000));
            line.run(200'000);
        }
        QCOMPARE(line.counts().good, 40u);
        QCOMPARE(line.counts(), line.seen);
        QCOMPARE(line.physical, line.seen.cut);
    }
    QVERIFY2(starts > 5 && starts < 50, qPrintable(QString::number(starts)));
}

void TestOrder::aRunGoesOnWithoutStop()
{
    for (const unsigned action : {CTL_ORDER_ACTION_NONE, CTL_ORDER_ACTION_MESSAGE}) {
        Line line;
        QCOMPARE(line.order(10, static_cast<std::uint16_t>(action)), CTL_REFUSAL_NONE);
        line.start();
        QVERIFY(line.runAndSee(10'000'000, false));
        QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(line.state(), CTL_ORDER_STATE_COMPLETE);
        QCOMPARE(line.counts().good, 10u);
        QCOMPARE(line.counts(), line.seen);
        QVERIFY(line.physical > 30);
    }
}

void TestOrder::changesAndEnds()
{
    Line line;
    QCOMPARE(line.order(1000), CTL_REFUSAL_NONE);
    line.start();
    line.runAndSee(10'000'000, false);
    const Counts before = line.counts();
    QVERIFY(before.good > 20);
    // Fewer, and the counts stay.
    QCOMPARE(line.order(before.good + 30), CTL_REFUSAL_NONE);
    QVERIFY(line.runAndSee(60'000'000));
    line.run(200'000);
    QCOMPARE(line.state(), CTL_ORDER_STATE_COMPLETE);
    QCOMPARE(line.counts().good, before.good + 30);
    // The next one begins anew, and ends early with its bag on the way counted.
    QCOMPARE(line.order(500, CTL_ORDER_ACTION_STOP, 8), CTL_REFUSAL_NONE);
    QCOMPARE(line.counts(), Counts{});
    line.start();
    line.run(5'000'000);
    QCOMPARE(line.command(CTL_COMMAND_ORDER_END, 7), CTL_REFUSAL_NO_ORDER);
    while (!line.core().order.on_the_way)
        line.controller().step();
    QCOMPARE(line.command(CTL_COMMAND_ORDER_END, 8), CTL_REFUSAL_NONE);
    QCOMPARE(line.state(), CTL_ORDER_STATE_ENDED);
    const Counts ended = line.counts();
    QCOMPARE(ended.good + ended.rejected + ended.empty, ended.cut);
    line.run(2'000'000);
    QCOMPARE(line.counts(), ended);
    QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(line.command(CTL_COMMAND_ORDER_END, 8), CTL_REFUSAL_NO_ORDER);
}

void TestOrder::wrongOrdersAreRefused()
{
    Line line;
    QCOMPARE(line.order(0), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(line.order(1'000'001), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(line.order(1'000'000'000), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(line.order(5, 3), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(line.order(5, CTL_ORDER_ACTION_STOP, 0), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(line.state(), CTL_ORDER_STATE_NONE);
    QCOMPARE(line.order(5), CTL_REFUSAL_NONE);
    QCOMPARE(line.order(5, CTL_ORDER_ACTION_STOP, number + 1), CTL_REFUSAL_ORDER_UNDER_WAY);
    Rig mover;
    mover.install(rampAndHold().registers());
    QCOMPARE(mover.command(CTL_COMMAND_ORDER_START, 1, CTL_ORDER_ACTION_STOP, 5), CTL_REFUSAL_NO_BAGS);
}

void TestOrder::powerCutKeepsTheCount()
{
    MemoryFlash flash;
    MachineOptions options;
    options.products.missing = 0.05;
    Line line(options, 300.0, Leader::Clock, &flash);
    std::mt19937_64 random(3);
    QCOMPARE(line.status(CTL_REG_ORDER_STATUS_KEPT), 1);
    const Registers lot(CTL_GROUP_ORDER, 0x4142);
    QCOMPARE(line.write(CTL_REG_ORDER_LOT, lot), 0);
    QCOMPARE(line.order(100'000), CTL_REFUSAL_NONE);
    Counts before;
    for (int i = 0; i < 200; ++i) {
        if (line.core().motion.state == CTL_STATE_READY)
            line.start();
        QVERIFY(line.runAndSee(random() % 6'000'000 + 1, false));
        before = line.counts();
        const std::uint16_t unknown = line.onTheWay();
        line.controller().restart();
        QCOMPARE(line.write(CTL_REG_ORDER_LOT, Registers(CTL_GROUP_ORDER, 0)), 0); // of the next order
        const Counts after = line.counts();
        QCOMPARE(line.state(), CTL_ORDER_STATE_ACTIVE);
        QCOMPARE(line.status(CTL_REG_ORDER_STATUS_NUMBER), number);
        QCOMPARE(line.read(CTL_REG_ORDER_STATUS_LOT, CTL_GROUP_ORDER), lot);
        QCOMPARE(line.statusWide(CTL_REG_ORDER_STATUS_QUANTITY), 100'000u);
        QCOMPARE(after, (Counts{before.good, before.rejected + unknown, before.empty, before.cut}));
        QCOMPARE(line.onTheWay(), 0);
        line.installFor(300.0);
    }
    QVERIFY(before.good > 500);
}

void TestOrder::withoutARecordItSaysSo()
{
    MemoryFlash flash;
    flash.hasRecords = false;
    Line line(calm(), 300.0, Leader::Clock, &flash);
    QCOMPARE(line.order(100), CTL_REFUSAL_NONE);
    QCOMPARE(line.status(CTL_REG_ORDER_STATUS_KEPT), 0);
    line.controller().restart();
    QCOMPARE(line.state(), CTL_ORDER_STATE_NONE);
}

void TestOrder::recordOfAnotherVersionIsNone()
{
    MemoryFlash flash;
    Line line(calm(), 300.0, Leader::Clock, &flash);
    QCOMPARE(line.order(100), CTL_REFUSAL_NONE);
    const Bytes good = flash.records[0];
    for (const std::size_t byte : {1u, 3u, 7u}) { // version, state, action
        flash.records[0] = good;
        flash.records[0].at(byte) = 9;
        line.controller().restart();
        QCOMPARE(line.state(), CTL_ORDER_STATE_NONE);
    }
    flash.records[0] = Bytes(good.begin(), good.end() - 1);
    line.controller().restart();
    QCOMPARE(line.state(), CTL_ORDER_STATE_NONE);
    flash.records[0] = good;
    line.controller().restart();
    QCOMPARE(line.state(), CTL_ORDER_STATE_ACTIVE);
}

// The jaws stand on the film behind a cut for too long: its bag is recorded already, and still rejected.
void TestOrder::bagSpoiledBehindItsCutIsRejected()
{
    Line line;
    line.setParameter(CTL_REG_PARAMETER_JAWS_BEFORE, 2500);
    line.setParameter(CTL_REG_PARAMETER_JAWS_BEHIND, 2500);
    line.setParameter(CTL_REG_PARAMETER_PARK_DELAY, 3000);
    line.setParameter(CTL_REG_PARAMETER_JAWS_CLOSED_MAX, 1000);
    line.order(1000);
    line.start();
    line.run(10'000'000);
    const auto fromCut = [&line] {
        const ctl_motion& motion = line.core().motion;
        return static_cast<double>(motion.commanded - motion.park.cycle_at - line.core().packer.cut_pulses) *
               360.0 / 10000.0;
    };
    for (int attempt = 0; attempt < 400; ++attempt) {
        line.run(1000u * static_cast<unsigned>(attempt % 200));
        (void)ctl_motion_stop_now(&line.core().motion);
        while (line.core().motion.ramp.speed != 0)
            line.controller().step();
        line.run(200'000);
        if (fromCut() > 4.0 && fromCut() < 20.0)
            break;
        line.runUntilState(CTL_STATE_READY);
        line.command(CTL_COMMAND_START);
        line.run(4'000'000);
    }
    QVERIFY(fromCut() > 4.0 && fromCut() < 20.0);
    const Counts before = line.counts();
    QCOMPARE(line.onTheWay(), 1);
    QVERIFY(line.runUntilState(CTL_STATE_READY));
    line.run(200'000);
    const Counts after = line.counts();
    QCOMPARE(line.onTheWay(), 0);
    QCOMPARE(after, (Counts{before.good, before.rejected + 1, before.empty, before.cut}));
}

// CAMPANEL_RANDOM_CASES orders of any quantity, rate and ramp, with products that are missing or lie
// anywhere, stops in between and power cuts: each ends at its quantity.
void TestOrder::randomOrdersEndAtTheirQuantity()
{
    const int cases = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES");
    std::mt19937_64 random(20);
    const auto share = [&random] { return static_cast<double>(random() % 1'000'000) / 1e6; };
    std::uint32_t surplus = 0;
    for (int i = 0; i < (cases == 0 ? 12 : cases); ++i) {
        MemoryFlash flash;
        MachineOptions options;
        options.products.missing = share() < 0.5 ? 0.0 : 0.1 * share();
        options.products.misplaced = share() < 0.5 ? 0.0 : 0.1 * share();
        const double rate = 60.0 + 240.0 * share();
        Line line(options, rate, Leader::Clock, &flash);
        line.setParameter(CTL_REG_PARAMETER_RAMP_TIME, static_cast<std::uint16_t>(100 + random() % 1900));
        const auto quantity = static_cast<std::uint32_t>(1 + random() % 150);
        QCOMPARE(line.order(quantity), CTL_REFUSAL_NONE);
        int starts = 0;
        while (line.state() == CTL_ORDER_STATE_ACTIVE && ++starts < 200) {
            QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
            const bool isBrokenOff = share() < 0.3;
            QVERIFY(line.runAndSee(isBrokenOff ? 1 + random() % 30'000'000 : 300'000'000));
            if (isBrokenOff && share() < 0.5) {
                line.controller().restart();
                line.installFor(rate);
            } else {
                (void)ctl_motion_stop_now(&line.core().motion);
                QVERIFY(line.runAndSee(300'000'000));
            }
            line.run(200'000);
        }
        const QByteArray what =
            QStringLiteral("order %1 of %2 bags at %3/min").arg(i).arg(quantity).arg(rate).toUtf8();
        QVERIFY2(line.state() == CTL_ORDER_STATE_COMPLETE, what);
        QVERIFY2(line.counts().good == quantity, what);
        QVERIFY2(line.counts().cut == line.seen.cut, what);
        surplus += line.physical - line.seen.cut;
    }
    QVERIFY2(surplus == 0, qPrintable(QStringLiteral("%1 bags too many").arg(surplus)));
}

CAMPANEL_TEST(TestOrder)

} // namespace test_order

#include "test_order.moc"
