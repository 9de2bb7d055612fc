// SPDX-License-Identifier: Apache-2.0
// Hot jaws behind a stop: the knife opens as a part of it and is back in its place before the next run.
#include "rig.h"

#include "packer/ctl_packer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_park {

using namespace campanel::test;
namespace controller = campanel::controller;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr std::uint16_t touchesCentiDeg = 2500; // the simulated jaws touch within 20 degrees of the cut

class Line : public Rig {
public:
    explicit Line(std::uint16_t centiDeg = touchesCentiDeg)
    {
        BankImage bank = camBank(10000, 1, cycleTicks);
        bank.bagLengthUm = 250'000;
        install(bank);
        setParameter(CTL_REG_PARAMETER_JAWS_BEFORE, centiDeg);
        setParameter(CTL_REG_PARAMETER_JAWS_BEHIND, centiDeg);
        start();
        run(20 * cycleUs);
    }

    // Stops at once, so that the knife comes to rest so far from its cut, to some degrees; negative: before
    // it.
    bool stopAt(double degrees)
    {
        for (int attempt = 0; attempt < 400; ++attempt) {
            runUntilClosed(false);
            run(1000u * static_cast<unsigned>(attempt % 200));
            (void)ctl_motion_stop_now(&core().motion);
            while (core().motion.ramp.speed != 0)
                controller().step();
            if (std::abs(fromCut() - degrees) < 4.0)
                return true;
            runUntilState(CTL_STATE_READY);
            command(CTL_COMMAND_START);
            runUntilState(CTL_STATE_RUNNING);
            run(6 * cycleUs);
        }
        return false;
    }

    double fromCut()
    {
        const ctl_motion& motion = core().motion;
        return static_cast<double>(motion.commanded - motion.park.cycle_at - core().packer.cut_pulses) *
               360.0 / 10000.0;
    }
    bool isClosed() { return controller().machine().areJawsClosed(); }
    void runUntilClosed(bool isClosed)
    {
        while (controller().machine().areJawsClosed() != isClosed)
            controller().step();
    }
    bool has(unsigned warning) { return (status(CTL_REG_STATUS_WARNING) >> warning & 1u) != 0; }
    unsigned flagsOfBag(std::uint32_t number)
    {
        return core().packer.records[CTL_BAG_REGISTERS * (number % CTL_BAG_RECORDS) + 3];
    }
    bool startAgain()
    {
        return command(CTL_COMMAND_START) == CTL_REFUSAL_NONE && runUntilState(CTL_STATE_RUNNING);
    }
    // Returns the bag bits of the next bags, all of them in one.
    unsigned flagsOfNext(std::uint32_t bags)
    {
        const std::uint32_t before = core().packer.bags;
        while (core().packer.bags < before + bags)
            controller().step();
        unsigned flags = 0;
        for (std::uint32_t i = 1; i <= bags; ++i)
            flags |= flagsOfBag(before + i);
        return flags;
    }
    // Runs until the jaws touch the film, so far from the cut at least, then sets the fault off.
    void failClosed(unsigned faultBit)
    {
        do {
            runUntilClosed(false);
            runUntilClosed(true);
            run(5000);
        } while (!isClosed());
        if (faultBit == CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED)
            core().banks.bank[core().banks.active].registers[CTL_BANK_HEADER_REGISTERS] ^= 1u;
        ctl_motion_fault(&core().motion, static_cast<std::uint16_t>(faultBit));
    }
    // Returns for how long the jaws touch the film within this time.
    std::uint64_t closedUs(std::uint64_t timeUs)
    {
        const std::uint64_t until = controller().nowUs() + timeUs;
        std::uint64_t closed = 0;
        while (controller().nowUs() < until) {
            controller().step();
            closed += isClosed() ? controller().stepUs() : 0;
        }
        return closed;
    }
};

constexpr unsigned burned = 1u << CTL_BAG_BIT_BURNED;
constexpr unsigned startUp = 1u << CTL_BAG_BIT_START_UP;

} // namespace

class TestPark : public QObject {
    Q_OBJECT

private slots:
    // Before the cut it goes back, behind it on: never through it. The run goes on without scrap.
    void opensAndReturns_data()
    {
        QTest::addColumn<double>("from");
        QTest::newRow("before the cut") << -12.0;
        QTest::newRow("behind the cut") << 12.0;
    }
    void opensAndReturns()
    {
        QFETCH(double, from);
        Line line;
        QVERIFY(line.stopAt(from));
        QVERIFY(line.isClosed());
        const std::int64_t place = line.core().motion.commanded;
        const std::int64_t film = line.core().packer.film_sent;
        QCOMPARE(line.core().motion.state, CTL_STATE_STOPPING);
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        line.run(300'000);
        QVERIFY(!line.isClosed());
        QVERIFY(std::abs(line.fromCut()) > 20.0);
        QCOMPARE(line.fromCut() < 0, from < 0);
        QCOMPARE(line.core().packer.film_sent, film);
        const std::uint32_t bags = line.core().packer.bags;
        QVERIFY(line.startAgain());
        bool wasThere = false;
        while (line.core().motion.manual) {
            line.controller().step();
            wasThere = wasThere || line.core().motion.commanded == place;
        }
        QVERIFY(wasThere);
        line.runUntilClosed(false);
        line.runUntilClosed(true);
        line.runUntilClosed(false);
        QCOMPARE(line.core().packer.bags, bags + (from < 0 ? 2u : 1u)); // none is lost
        QCOMPARE(line.flagsOfNext(4) & (burned | startUp), 0u);
        QVERIFY(!line.has(CTL_WARNING_BIT_JAWS_CLOSED));
    }

    void waitsAsLongAsItIsTold()
    {
        Line line;
        line.setParameter(CTL_REG_PARAMETER_PARK_DELAY, 400);
        QVERIFY(line.stopAt(-12.0));
        const std::int64_t place = line.core().motion.commanded;
        line.run(390'000);
        QCOMPARE(line.core().motion.commanded, place);
        line.run(200'000);
        QVERIFY(line.core().motion.commanded < place);
    }

    // A machine whose jaws are not known stays where it was stopped.
    void staysWhereNothingIsKnown()
    {
        Line line(0);
        QVERIFY(line.stopAt(-12.0));
        const std::int64_t place = line.core().motion.commanded;
        QVERIFY(line.runUntilState(CTL_STATE_READY, 10'000));
        line.run(3'000'000);
        QCOMPARE(line.core().motion.commanded, place);
        QVERIFY(!line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        QVERIFY(line.startAgain());
        QCOMPARE(line.flagsOfNext(4) & burned, 0u);
    }

    // Whoever stops the opening, too, is told that the jaws are closed, and the bags at the knife are marked.
    void secondStopHolds_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<unsigned>("bags");
        QTest::newRow("before the cut: both bags come") << -12.0 << 2u;
        QTest::newRow("behind the cut: one is made") << 8.0 << 1u;
    }
    void secondStopHolds()
    {
        QFETCH(double, from);
        QFETCH(unsigned, bags);
        Line line;
        line.setParameter(CTL_REG_PARAMETER_PARK_DELAY, 100);
        QVERIFY(line.stopAt(from));
        line.run(20'000);
        QCOMPARE(line.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
        QVERIFY(line.runUntilState(CTL_STATE_READY, 100'000));
        line.run(800'000);
        QVERIFY(!line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        line.run(300'000);
        QVERIFY(line.isClosed());
        QVERIFY(line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        QVERIFY(line.startAgain());
        QVERIFY(!line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        QVERIFY((line.flagsOfNext(1) & burned) != 0);
        if (bags == 2)
            QVERIFY((line.flagsOfNext(1) & burned) != 0);
        QCOMPARE(line.flagsOfNext(3) & burned, 0u);
    }

    // Under an emergency stop nothing moves; the bags are scrap from the first moment.
    void emergencyStopHolds()
    {
        Line line;
        line.runUntilClosed(true);
        line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        for (int i = 0; i < 50; ++i) { // until one leaves the jaws closed
            line.runUntilState(CTL_STATE_READY);
            if (line.isClosed())
                break;
            line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
            line.run(2'500'000);
            QVERIFY(line.startAgain());
            line.run(6 * cycleUs + 4'000u * static_cast<unsigned>(i));
            line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        }
        QVERIFY(line.isClosed());
        const std::int64_t place = line.core().motion.commanded;
        line.run(200'000);
        QCOMPARE(line.core().motion.commanded, place);
        line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
        line.run(2'500'000);
        QCOMPARE(line.core().motion.commanded, place);
        QVERIFY(line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        QVERIFY(line.startAgain());
        QVERIFY((line.flagsOfNext(1) & burned) != 0);
    }

    // A damaged table says nothing against the axis: the knife opens although the fault is there at once. The
    // other faults mean that the axis may not move.
    void opensBehindAFaultThatLetsTheAxisMove_data()
    {
        QTest::addColumn<unsigned>("fault");
        QTest::addColumn<bool>("opens");
        QTest::newRow("damaged table") << unsigned{CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED} << true;
        QTest::newRow("drive alarm") << unsigned{CTL_FAULT_BIT_DRIVE_ALARM} << false;
        QTest::newRow("following error") << unsigned{CTL_FAULT_BIT_FOLLOWING_ERROR} << false;
        QTest::newRow("drive does not follow") << unsigned{CTL_FAULT_BIT_DRIVE_NOT_FOLLOWING} << false;
    }
    void opensBehindAFaultThatLetsTheAxisMove()
    {
        QFETCH(unsigned, fault);
        QFETCH(bool, opens);
        Line line;
        line.setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE, CTL_DRIVE_ENABLE_WHILE_RUNNING);
        line.failClosed(fault);
        const std::int64_t film = line.core().packer.film_sent;
        const std::uint64_t closed = line.closedUs(3'000'000);
        QVERIFY2(opens == (closed < 1'000'000), qPrintable(QString::number(closed)));
        QCOMPARE(line.has(CTL_WARNING_BIT_JAWS_CLOSED), !opens);
        QCOMPARE(line.core().motion.state, CTL_STATE_FAULT);
        QCOMPARE(line.core().motion.fault, 1u << fault);
        QVERIFY(ctl_motion_standstill(&line.core().motion));
        QVERIFY(!line.core().motion.manual);
        QVERIFY(!line.core().motion.in_phase);
        QCOMPARE(line.core().packer.film_sent, film);
    }

    // Whatever ends a motion ends the opening too, and the fault stays what it was.
    void openingBehindAFaultIsEnded_data()
    {
        QTest::addColumn<int>("by");
        QTest::newRow("emergency stop") << 0;
        QTest::newRow("drive alarm") << 1;
        QTest::newRow("stop") << 2;
        QTest::newRow("following error") << 3;
    }
    void openingBehindAFaultIsEnded()
    {
        QFETCH(int, by);
        Line line;
        line.setParameter(CTL_REG_PARAMETER_PARK_DELAY, 100);
        line.failClosed(CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
        line.run(50'000);
        QVERIFY(!ctl_motion_standstill(&line.core().motion));
        QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_FAULT_PERSISTS);
        QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_IN_FAULT);
        unsigned faults = 1u << CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED;
        controller::Machine& machine = line.controller().machine();
        if (by == 0) {
            machine.setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        } else if (by == 1) {
            machine.setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
            faults |= 1u << CTL_FAULT_BIT_DRIVE_ALARM;
        } else if (by == 2) {
            QCOMPARE(line.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
        } else {
            line.setParameter(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT + 1, 10);
            machine.setDriveOn(false);
            faults |= 1u << CTL_FAULT_BIT_FOLLOWING_ERROR;
            line.run(300'000);
        }
        line.run(5'000);
        QVERIFY(ctl_motion_standstill(&line.core().motion));
        QVERIFY(!line.core().motion.manual);
        const std::int64_t place = line.core().motion.commanded;
        line.run(3'000'000);
        QCOMPARE(line.core().motion.commanded, place);
        QCOMPARE(line.core().motion.state, CTL_STATE_FAULT);
        QCOMPARE(line.core().motion.fault, faults);
        QVERIFY(line.has(CTL_WARNING_BIT_JAWS_CLOSED));
        QCOMPARE(line.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NOT_RUNNING);
    }

    // Stopped in the first slice behind its return, too: where the cut is is not worked out anew for a start.
    void opensAgainAtOnce()
    {
        Line line;
        QVERIFY(line.stopAt(-12.0));
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        QVERIFY(line.startAgain());
        while (line.core().motion.manual)
            line.controller().step();
        QVERIFY(line.isClosed());
        QCOMPARE(ctl_motion_stop_now(&line.core().motion), CTL_REFUSAL_NONE);
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        line.run(300'000);
        QVERIFY(!line.isClosed());
    }

    // Stopped on its way back, it opens again; jogged away from there, it homes.
    void isStoppedOnItsWayBack()
    {
        Line line;
        QVERIFY(line.stopAt(-12.0));
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        // An emergency stop that is over says nothing of the next run.
        line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        line.run(100'000);
        line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
        line.run(2'500'000);
        QVERIFY(line.startAgain());
        line.runUntilClosed(true);
        QVERIFY(line.core().motion.manual);
        QCOMPARE(line.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        line.run(300'000);
        QVERIFY(!line.isClosed());
        line.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        line.run(100'000);
        line.heartbeat();
        QVERIFY(line.runUntilState(CTL_STATE_READY, 1'000'000));
        QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        line.run(10'000);
        QCOMPARE(line.core().motion.state, CTL_STATE_HOMING);
        QVERIFY(line.runUntilState(CTL_STATE_RUNNING));
        QVERIFY(!line.core().motion.manual);
    }
};

CAMPANEL_TEST(TestPark)

} // namespace test_park

#include "test_park.moc"
