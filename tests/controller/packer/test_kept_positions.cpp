// SPDX-License-Identifier: Apache-2.0
// A machine whose positions survive a power cut: the knife goes to its home without a search, wherever it was
// turned to. The film is believed only at its next mark all the same.
#include "rig.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <stdexcept>

namespace test_kept_positions {

using namespace campanel::test;
namespace controller = campanel::controller;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s
constexpr std::uint64_t cycleUs = 200'000;
constexpr std::int64_t revolution = 10'000;
constexpr std::uint16_t all =
    1u << CTL_IO_BIT_AXIS_KEPT | 1u << CTL_IO_BIT_FILM_KEPT | 1u << CTL_IO_BIT_INFEED_KEPT;

controller::MachineOptions countsFromItsMark()
{
    controller::MachineOptions options;
    options.startAngleDegrees = 0;
    return options;
}

class Line : public Rig {
public:
    explicit Line(std::uint16_t kept)
        : Rig(countsFromItsMark())
        , m_kept(kept)
    {
        core().board.config.kept_positions = kept;
        BankImage bank = camBank(revolution, 1, cycleTicks);
        bank.bagLengthUm = 250'000;
        install(bank);
        setParameter(CTL_REG_PARAMETER_THREAD_UP, 1);
        setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 1);
        if (command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers())) != CTL_REFUSAL_NONE)
            throw std::runtime_error("the program is not saved");
    }

    // While it has no power, somebody turns the shaft and moves film and infeed.
    void cutPower(const controller::Machine::ByHand& byHand)
    {
        controller().machine().standStill(byHand);
        controller().restart();
        core().board.config.kept_positions = m_kept;
    }
    // Starts, and returns true when the index mark was searched on the way to the run.
    bool searchesUntilItRuns()
    {
        if (command(CTL_COMMAND_START) != CTL_REFUSAL_NONE)
            throw std::runtime_error("the program does not start");
        bool searches = false;
        for (int i = 0; i < 400'000 && core().motion.state != CTL_STATE_RUNNING; ++i) {
            searches = searches ||
                       (core().motion.state == CTL_STATE_HOMING && core().motion.homing == CTL_HOMING_SEARCH);
            controller().step();
        }
        return searches;
    }
    bool isAtItsMark() { return core().motion.commanded % revolution == 0; }
    // Returns how far the next cut is from its mark, mm.
    double nextCutMm()
    {
        do
            controller().step();
        while (!controller().cut());
        return std::abs(controller().cut()->markErrorMm);
    }
    bool isNewestScrap()
    {
        const ctl_packer& packer = core().packer;
        const unsigned flags = packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3];
        return (flags & 1u << CTL_BAG_BIT_START_UP) != 0;
    }

private:
    std::uint16_t m_kept;
};

} // namespace

class TestKeptPositions : public QObject {
    Q_OBJECT

private slots:
    void turnsAreCountedFromTheMark()
    {
        Rig rig;
        rig.install(camBank(revolution, 1, cycleTicks));
        const ctl_bank* bank = ctl_active_bank(&rig.core().banks);
        for (const double turns : {-1e12, -3.0, -1.0, 0.0, 1.0, 2.0, 7e4, 1e12}) {
            const std::int64_t at = std::llround(turns) * revolution;
            QCOMPARE(ctl_bank_nearest_turn(bank, at), at);
            QCOMPARE(ctl_bank_nearest_turn(bank, at + revolution / 2 - 1), at);
            QCOMPARE(ctl_bank_nearest_turn(bank, at - revolution / 2), at);
            QCOMPARE(ctl_bank_nearest_turn(bank, at + revolution / 2), at + revolution);
        }
    }

    void goesHomeWithoutASearch_data()
    {
        QTest::addColumn<double>("turns");
        for (const double turns : {0.0, 0.2, 0.8, 17.4, -0.1, -0.7, -5.3})
            QTest::addRow("%g turns", turns) << turns;
    }
    void goesHomeWithoutASearch()
    {
        QFETCH(double, turns);
        Line line(all);
        QCOMPARE(line.status(CTL_REG_IO_AVAILABLE) & all, unsigned{all});
        line.cutPower({turns, 120.0, 0.4});
        QVERIFY(!line.searchesUntilItRuns());
        QVERIFY(line.isAtItsMark());
        QCOMPARE(line.core().motion.origin, std::llround(turns) * revolution);
        QVERIFY(line.core().motion.homed && line.core().motion.in_phase);
    }

    // All boards that there are: the place is not known.
    void searchesWhereNothingIsKept()
    {
        Line line(0);
        QCOMPARE(line.status(CTL_REG_IO_AVAILABLE) & all, 0u);
        line.cutPower({0.2, 0.0, 0.0});
        QVERIFY(line.searchesUntilItRuns());
        QVERIFY(line.isAtItsMark());
    }

    // Turned and pulled by hand or not, whatever the port says of the film: no cut is made before it follows
    // a mark, and none is off and unmarked.
    void filmIsBelievedAtItsNextMark_data()
    {
        QTest::addColumn<int>("kept");
        QTest::newRow("all kept") << int{all};
        QTest::newRow("film only") << (1 << CTL_IO_BIT_FILM_KEPT);
        QTest::newRow("none") << 0;
    }
    void filmIsBelievedAtItsNextMark()
    {
        QFETCH(int, kept);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        Line line(static_cast<std::uint16_t>(kept));
        for (int cut = 0; cut < 12; ++cut) {
            line.run(static_cast<std::uint64_t>(cycleUs * part(random)));
            line.cutPower(
                cut % 2 == 0 ? controller::Machine::ByHand{}
                             : controller::Machine::ByHand{part(random), 250.0 * part(random), part(random)});
            line.searchesUntilItRuns();
            QVERIFY(line.core().packer.threading);
            const double firstMm = line.nextCutMm();
            QVERIFY(line.core().packer.last_cut.tracked);
            QVERIFY(!line.core().packer.threading);
            QCOMPARE(line.core().packer.marks.state, CTL_MARK_STATE_TRACKING);
            QVERIFY2(firstMm < 5.0, qPrintable(QString::number(firstMm)));
            for (int bag = 0; bag < 4; ++bag) {
                const double offMm = line.nextCutMm();
                QVERIFY2(offMm < 0.5 || line.isNewestScrap(), qPrintable(QString::number(offMm)));
            }
        }
    }
};

CAMPANEL_TEST(TestKeptPositions)

} // namespace test_kept_positions

#include "test_kept_positions.moc"
