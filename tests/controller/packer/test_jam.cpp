// SPDX-License-Identifier: Apache-2.0
// Something under the closing jaws: seen by the knife's torque, stopped, left, and the run goes on from
// there.
#include "rig.h"

#include "packer/ctl_jam.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace test_jam {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr int revolution = 10'000;
constexpr std::uint16_t backCentiDeg = 6000;

MachineOptions sealing()
{
    MachineOptions options;
    options.jaws.sealNm = 0.5;
    options.drive.inertiaKgM2 = 0.0003; // the bank of the tests accelerates it by jerks
    return options;
}

// The same with an encoder on the line's shaft.
MachineOptions rippling()
{
    MachineOptions options = sealing();
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = 1250.0;
    options.shaft.ripple = 0.01;
    return options;
}

class Line : public Rig {
public:
    explicit Line(const MachineOptions& options = sealing())
        : Rig(options)
    {
        BankImage bank = camBank(revolution, 1, cycleTicks);
        bank.bagLengthUm = 250'000;
        install(bank);
        setParameter(CTL_REG_PARAMETER_JAM_DETECTION, 1);
        setParameter(CTL_REG_PARAMETER_JAM_STOP_TIME, 20);
        setParameter(CTL_REG_PARAMETER_JAM_BACK, backCentiDeg);
        start();
    }

    void followEncoder()
    {
        command(CTL_COMMAND_STOP_NOW);
        (void)runUntilState(CTL_STATE_READY);
        write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        run(500'000);
        command(CTL_COMMAND_START);
    }
    unsigned jam(std::uint16_t address) { return status(address); }
    double jamDegrees(std::uint16_t address) { return static_cast<std::int16_t>(status(address)) / 100.0; }
    void block(bool on) { controller().machine().jaws().setBlocked(on); }
    // Returns true when a jam has stopped the machine.
    bool jams()
    {
        block(true);
        const bool stopped = runUntilState(CTL_STATE_FAULT, 2'000'000);
        block(false);
        return stopped && core().motion.fault == 1u << CTL_FAULT_BIT_JAM;
    }
    bool goesOn()
    {
        run(50'000);
        return command(CTL_COMMAND_RESET_FAULT) == CTL_REFUSAL_NONE &&
               command(CTL_COMMAND_START) == CTL_REFUSAL_NONE && runUntilState(CTL_STATE_RUNNING);
    }
    // Returns the bag bits of the next bags, one by one.
    std::vector<unsigned> flagsOfNext(std::uint32_t bags)
    {
        std::vector<unsigned> flags;
        while (flags.size() < bags) {
            const std::uint32_t before = core().packer.bags;
            controller().step();
            if (core().packer.bags != before)
                flags.push_back(
                    core().packer.records[CTL_BAG_REGISTERS * (core().packer.bags % CTL_BAG_RECORDS) + 3] &
                    0xFFu);
        }
        return flags;
    }
};

// The torque of a knife, slice by slice, without a machine: 1000 pulses a cycle, judged from -250 to 50.
struct Torques {
    ctl_jam jam{};
    std::uint32_t us = 0;
    std::uint32_t cycle = 0;
    int intervalUs = 250;
    int held = 0;

    Torques()
    {
        const ctl_jam_settings settings{true, true, -264, 64, 14, 0, 50};
        ctl_jam_set(&jam, &settings);
    }
    // Returns true when there was a jam in this cycle.
    bool pass(const std::function<int(int)>& torque, std::uint32_t share = CTL_JAM_FULL_SPEED)
    {
        ++cycle;
        for (int at = -600; at < 400; at += 5) {
            us += 250;
            if (us % static_cast<unsigned>(intervalUs) == 0)
                held = torque(at);
            const ctl_jam_slice slice{us, cycle, at, true, share, false, held};
            if (ctl_jam_watch(&jam, &slice))
                return true;
        }
        return false;
    }
    void learn(const std::function<int(int)>& torque)
    {
        for (unsigned i = 0; i < CTL_JAM_CYCLES + 2; ++i)
            pass(torque);
    }
};

// A knife that brakes as it closes, and a drive whose last digit flickers: the mean is 100 - 100 x 60 / 200
// = 70.
int brakes(int at)
{
    return (at >= -270 && at < 70 ? 0 : 100) + at / 5 % 2;
}

} // namespace

class TestJam : public QObject {
    Q_OBJECT

private slots:
    // At full speed the band ends at friction + what is usual there + margin = 66 - 66 + 50; at 0.9 of the
    // speed at 66 - 66 x 0.81 + 100, because a ramp doubles the margin; and by four times the flicker of 0.5
    // to 1.
    void theBandIsFrictionAndWhatIsUsual()
    {
        const auto with = [](int more) {
            return [more](int at) { return brakes(at) + (at >= -100 && at < -50 ? more : 0); };
        };
        Torques torques;
        torques.learn(brakes);
        QCOMPARE(ctl_jam_state(&torques.jam), CTL_JAM_STATE_ARMED);
        QVERIFY(std::abs(torques.jam.friction - 66 * 16) <= 16);
        Torques less = torques;
        QVERIFY(!less.pass(with(49)));
        QVERIFY(torques.pass(with(57)));
        QCOMPARE(torques.jam.last.source, CTL_JAM_SOURCE_TORQUE);
        QVERIFY2(torques.jam.last.limit >= 50 && torques.jam.last.limit <= 56,
                 qPrintable(QString::number(torques.jam.last.limit)));
        QVERIFY2(torques.jam.last.at >= -85 && torques.jam.last.at <= -75, // 1 ms behind -100
                 qPrintable(QString::number(torques.jam.last.at)));
        const std::uint32_t share = CTL_JAM_FULL_SPEED * 9 / 10;
        QVERIFY(!torques.pass(with(111), share));
        QVERIFY(torques.pass(with(120), share));
    }

    // Friction that drifts by a third is no jam; neither is anything outside the closing range.
    void frictionIsFollowed()
    {
        Torques torques;
        torques.learn(brakes);
        for (int cycle = 0; cycle < 400; ++cycle)
            QVERIFY(!torques.pass([cycle](int at) { return brakes(at) + cycle / 4; }));
        QVERIFY(!torques.pass([](int at) { return brakes(at) + (at >= 64 && at < 110 ? 2000 : 0); }));
    }

    // Nothing is learned from a cycle with a jam, and a short peak is none.
    void aPeakIsNoJam()
    {
        Torques torques;
        torques.learn(brakes);
        QVERIFY(!torques.pass([](int at) { return brakes(at) + (at >= -100 && at < -85 ? 900 : 0); }));
        const ctl_jam before = torques.jam;
        QVERIFY(torques.pass([](int at) { return brakes(at) + (at >= -100 && at < 0 ? 900 : 0); }));
        torques.pass(brakes);
        for (unsigned i = 0; i < CTL_JAM_BINS; ++i)
            QVERIFY(std::abs(torques.jam.parts[i].mean - before.parts[i].mean) <= 16);
    }

    void aDriveThatSaysNothingIsNamed()
    {
        Torques torques;
        torques.learn([](int) { return 0; });
        QCOMPARE(ctl_jam_state(&torques.jam), CTL_JAM_STATE_NOT_REPORTED);
        Torques without;
        without.jam.settings.reports = false;
        QCOMPARE(ctl_jam_state(&without.jam), CTL_JAM_STATE_NOT_REPORTED);
    }

    // Five degrees last 0.7 ms here, so that 4 ms are allowed: three reports in them.
    void aSlowDriveIsNamed_data()
    {
        QTest::addColumn<int>("us");
        QTest::addColumn<int>("state");
        QTest::newRow("1.25 ms") << 1250 << int(CTL_JAM_STATE_ARMED);
        QTest::newRow("1.5 ms") << 1500 << int(CTL_JAM_STATE_TOO_SLOW);
        QTest::newRow("10 ms") << 10'000 << int(CTL_JAM_STATE_TOO_SLOW);
    }
    void aSlowDriveIsNamed()
    {
        QFETCH(int, us);
        QFETCH(int, state);
        Torques torques;
        torques.intervalUs = us;
        torques.learn([](int at) { return brakes(at) + at / 5; });
        QCOMPARE(int(torques.jam.interval_us), us);
        QCOMPARE(int(ctl_jam_state(&torques.jam)), state);
        QVERIFY(state == CTL_JAM_STATE_ARMED ||
                !torques.pass([](int at) { return brakes(at) + (at < 0 ? 2000 : 0); }));
    }

    // 1000 bags whose torque at the cut is 2.1 % more than when it was learned.
    void theResidueIsRecorded()
    {
        Torques torques;
        torques.learn(brakes);
        for (int bag = 0; bag < 1000; ++bag)
            torques.pass([](int at) { return brakes(at) + (at >= -20 && at < 20 ? 21 : 0); });
        QCOMPARE(torques.jam.residue_number, 1u);
        // Friction becomes more by 21 x 8 / 200.
        QVERIFY2(std::abs(torques.jam.residue - 202) <= 4, qPrintable(QString::number(torques.jam.residue)));
    }

    // Stopped before the cut, gone back, told; then the run goes on from there, without a reference run.
    void theRunGoesOnFromAJam()
    {
        Line line;
        line.run(28 * cycleUs);
        QCOMPARE(line.jam(CTL_REG_JAM_STATE), unsigned(CTL_JAM_STATE_ARMED));
        const std::uint32_t number = line.core().packer.bags;
        QVERIFY(line.jams());
        const ctl_motion& motion = line.core().motion;
        QVERIFY(motion.in_phase && motion.homed);
        const auto cut = static_cast<double>(motion.park.cycle_at + line.core().packer.cut_pulses);
        const double seen = line.jamDegrees(CTL_REG_JAM_ANGLE);
        const double ranOn = line.jamDegrees(CTL_REG_JAM_RUN_ON);
        const double stands = 360.0 * (static_cast<double>(motion.commanded) - cut) / revolution;
        QVERIFY2(seen > -30.0 && seen + ranOn < 0.0, qPrintable(QString("%1 %2").arg(seen).arg(ranOn)));
        QVERIFY(ranOn > 0.0);
        QVERIFY2(std::abs(stands - (seen - 60.0)) < 0.1,
                 qPrintable(QString("%1 %2 %3").arg(stands).arg(seen).arg(ranOn)));
        QCOMPARE(line.jam(CTL_REG_JAM_NUMBER), 1u);
        QCOMPARE(line.jam(CTL_REG_JAM_SOURCE), unsigned(CTL_JAM_SOURCE_TORQUE));
        QVERIFY(static_cast<std::int16_t>(line.jam(CTL_REG_JAM_TORQUE)) >
                static_cast<std::int16_t>(line.jam(CTL_REG_JAM_LIMIT)));
        QVERIFY(line.goesOn());
        const std::vector<unsigned> flags = line.flagsOfNext(4);
        constexpr unsigned jammed = 1u << CTL_BAG_BIT_JAMMED;
        QVERIFY((flags[0] & jammed) != 0 && (flags[1] & jammed) != 0);
        QVERIFY((flags[2] & jammed) == 0 && (flags[3] & jammed) == 0);
        for (const unsigned each : flags)
            QVERIFY((each & 1u << CTL_BAG_BIT_START_UP) == 0);
        QVERIFY(line.core().packer.bags - number <= 7); // none is lost
        QCOMPARE(line.core().motion.origin, motion.origin);
    }

    void allAxesStopTogether()
    {
        Line line;
        line.run(28 * cycleUs);
        line.block(true);
        const ctl_packer& packer = line.core().packer;
        while (line.core().motion.state == CTL_STATE_RUNNING)
            line.controller().step();
        const std::int64_t film = packer.film_sent;
        const std::int64_t knife = line.core().motion.commanded;
        const auto knifeHz = static_cast<double>(line.core().motion.actual_hz);
        const double before = static_cast<double>(packer.master);
        std::int64_t steps = 0;
        while (line.core().motion.ramp.speed != 0) {
            line.controller().step();
            ++steps;
        }
        QVERIFY(steps >= 78 && steps <= 82); // 20 ms
        // The film's share of its bag is the master's of its cycle; the knife brakes evenly, but for its cam.
        const double share = (static_cast<double>(packer.master) - before) / cycleTicks;
        const double drawn = static_cast<double>(packer.film_sent - film) / (250.0 / 150.0 * 10'000.0);
        QVERIFY2(std::abs(drawn - share) < 1e-3, qPrintable(QString("%1 %2").arg(drawn).arg(share)));
        const double way =
            static_cast<double>(line.core().motion.commanded - knife) / (knifeHz * 0.020 / 2.0);
        QVERIFY2(way > 0.8 && way < 1.2, qPrintable(QString::number(way)));
    }

    // The torque-limit input is a jam while the jaws close, learned or not; elsewhere it is none.
    void theTorqueLimitIsAJam()
    {
        MachineOptions options;
        options.report.everyMs = 10;
        Line line(options);
        line.run(28 * cycleUs);
        QCOMPARE(line.jam(CTL_REG_JAM_STATE), unsigned(CTL_JAM_STATE_TOO_SLOW));
        QVERIFY(line.jams());
        QCOMPARE(line.jam(CTL_REG_JAM_SOURCE), unsigned(CTL_JAM_SOURCE_TORQUE_LIMIT));
        QVERIFY(line.goesOn());
        line.run(5 * cycleUs);
        while (line.core().packer.jam.inside)
            line.controller().step();
        line.controller().machine().setInput(CTL_INPUT_BIT_TORQUE_LIMIT, true);
        line.run(cycleUs / 20);
        line.controller().machine().setInput(CTL_INPUT_BIT_TORQUE_LIMIT, false);
        line.run(cycleUs);
        QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
    }

    void learnsAgainAfterAChange()
    {
        Line line;
        line.run(28 * cycleUs);
        QCOMPARE(line.jam(CTL_REG_JAM_CYCLES_LEFT), 0u);
        BankImage slower = camBank(revolution, 1, cycleTicks * 2);
        slower.bagLengthUm = 250'000;
        QCOMPARE(line.download(slower.registers(), 2), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(line.apply(slower.registers(), CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
        line.run(6 * cycleUs);
        QVERIFY(line.jam(CTL_REG_JAM_CYCLES_LEFT) > 10);
        QCOMPARE(line.jam(CTL_REG_JAM_STATE), unsigned(CTL_JAM_STATE_LEARNING));
    }

    // An encoder leads the line, with a ripple of 1 %: the run leaves it for the jam, and meets it again.
    void anEncoderMayLead()
    {
        Line line(rippling());
        line.followEncoder();
        line.run(60 * cycleUs);
        QVERIFY(line.core().master.leads);
        QCOMPARE(line.jam(CTL_REG_JAM_STATE), unsigned(CTL_JAM_STATE_ARMED));
        QCOMPARE(line.jam(CTL_REG_JAM_NUMBER), 0u);
        QVERIFY(line.jams());
        QVERIFY(!line.core().master.leads);
        QVERIFY(line.goesOn());
        line.run(20 * cycleUs);
        QVERIFY(line.core().master.leads);
        QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(line.jam(CTL_REG_JAM_NUMBER), 1u);
    }

    // The axes stop within 26 ms, so that the knife is sent beyond its cut and makes it on its way back to
    // its place. The film stands meanwhile, which says nothing of its lag.
    void aJamTeachesNoLag_data()
    {
        QTest::addColumn<bool>("leads");
        QTest::newRow("clock") << false;
        QTest::newRow("encoder") << true;
    }
    void aJamTeachesNoLag()
    {
        QFETCH(bool, leads);
        Line line(leads ? rippling() : sealing());
        line.setParameter(CTL_REG_PARAMETER_JAM_STOP_TIME, 26);
        if (leads)
            line.followEncoder();
        const ctl_packer& packer = line.core().packer;
        const int jams = std::max(4, qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES"));
        std::mt19937 random(3);
        std::uniform_int_distribution<std::uint64_t> runsUs(60 * cycleUs, 100 * cycleUs);
        for (int jam = 0; jam < jams; ++jam) {
            line.run(runsUs(random));
            while (packer.jam.inside) // nothing comes between closed jaws
                line.controller().step();
            QCOMPARE(line.core().master.leads, leads);
            const auto lag = static_cast<double>(packer.lag);
            QVERIFY(lag != 0.0);
            QVERIFY(line.jams());
            QVERIFY(line.goesOn());
            for (int bag = 0; bag < 8; ++bag) {
                const std::vector<unsigned> flags = line.flagsOfNext(1);
                const double off = std::abs(static_cast<double>(packer.lag) / lag - 1.0);
                QVERIFY2(off < 0.1, qPrintable(QString("jam %1, bag %2: %3").arg(jam).arg(bag).arg(off)));
                const unsigned scrap = 1u << CTL_BAG_BIT_JAMMED | 1u << CTL_BAG_BIT_START_UP;
                const double missedMm = std::abs(line.controller().cut()->markErrorMm);
                QVERIFY2((flags[0] & scrap) != 0 || missedMm < 0.4,
                         qPrintable(QString("jam %1, bag %2: %3 mm").arg(jam).arg(bag).arg(missedMm)));
            }
        }
    }

    // Somebody has turned the knife while he took it out: the next start looks for the index mark.
    void aTurnedKnifeGoesHome()
    {
        Line line;
        line.run(28 * cycleUs);
        QVERIFY(line.jams());
        line.controller().machine().standStill({0.01, 0.0, 0.0});
        line.run(10'000);
        QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
        QVERIFY(!line.core().motion.in_phase);
        QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QCOMPARE(line.core().motion.state, CTL_STATE_HOMING);
    }

    void anEmergencyStopHoldsTheKnife()
    {
        Line line;
        line.run(28 * cycleUs);
        line.block(true);
        while (line.core().motion.park.phase == CTL_PARK_OFF || line.core().motion.ramp.speed == 0)
            line.controller().step();
        line.run(20'000);
        line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        QVERIFY(line.runUntilState(CTL_STATE_FAULT, 500'000));
        const std::int64_t place = line.core().motion.commanded;
        line.run(1'000'000);
        QCOMPARE(line.core().motion.commanded, place);
        QCOMPARE(unsigned(line.core().motion.fault), 1u << CTL_FAULT_BIT_JAM);
    }

    // Off, as shipped: the axis is pressed on until its following error ends the run.
    void offAsShipped()
    {
        Line line;
        line.setParameter(CTL_REG_PARAMETER_JAM_DETECTION, 0);
        line.run(28 * cycleUs);
        QCOMPARE(line.jam(CTL_REG_JAM_STATE), unsigned(CTL_JAM_STATE_OFF));
        line.controller().machine().jaws().setBlocked(true);
        line.run(cycleUs);
        QVERIFY((line.core().motion.fault & 1u << CTL_FAULT_BIT_JAM) == 0);
        QVERIFY(line.controller().machine().jaws().cutThrough() +
                    (line.core().motion.state == CTL_STATE_FAULT ? 1u : 0u) >
                0);
    }
};

CAMPANEL_TEST(TestJam)

} // namespace test_jam

#include "test_jam.moc"
