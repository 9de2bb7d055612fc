// SPDX-License-Identifier: Apache-2.0
// A machine whose true pulses, film feed and directions are not those that the controller was told, and what
// is measured of them. The core reads nothing of the simulated machine but its pins and encoders.
#include "rig.h"
#include "support/press_image.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdio>
#include <functional>

namespace test_commissioning {

using namespace campanel::test;
namespace controller = campanel::controller;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 300 a minute
constexpr std::int64_t knifePulses = 10'000;    // of a cycle and of a turn, by the program
constexpr double bagMm = 250.0;

struct Run {
    int bags = 0;
    double meanMm = 0.0;
    double lastMm = 0.0; // of the stop, at another speed

    [[nodiscard]] double offPercent() const { return 100.0 * (meanMm / bagMm - 1.0); }
};

class Bench : public Rig {
public:
    explicit Bench(const MachineOptions& options)
        : Rig(options)
    {
        installFor(knifePulses);
        write(CTL_REG_PARAMETER_MARK_TRACKING, {0});
        write(CTL_REG_PARAMETER_ANTI_CUT, {0});
    }

    void installFor(std::int64_t pulsesPerTurn)
    {
        BankImage image = camBank(static_cast<std::uint32_t>(pulsesPerTurn), 1, cycleTicks);
        image.pulsesPerMotorRev = static_cast<std::uint32_t>(pulsesPerTurn);
        image.bagLengthUm = 250'000;
        install(image.registers(), ++m_session);
    }

    // Answers with a heartbeat every 20 ms, as a panel does, until the measurement is over.
    std::uint16_t measure(unsigned axis, unsigned turns, const std::function<void()>& inBetween = {})
    {
        heartbeat();
        const std::uint16_t refusal =
            command(CTL_COMMAND_MEASURE, static_cast<std::uint16_t>(axis), static_cast<std::uint16_t>(turns));
        if (refusal != CTL_REFUSAL_NONE)
            return refusal;
        for (int i = 0; i < 10'000 && core().motion.state == CTL_STATE_JOGGING; ++i) {
            if (i == 50 && inBetween)
                inBetween();
            if (!isSilent)
                heartbeat();
            run(20'000);
        }
        run(100'000); // the drives come to rest
        return refusal;
    }
    std::uint16_t state() { return status(CTL_REG_MEASURE_STATE); }
    std::uint16_t reason() { return status(CTL_REG_MEASURE_REASON); }
    double pulses() { return statusWide(CTL_REG_MEASURE_PULSES) / 100.0; }
    double spread() { return statusWide(CTL_REG_MEASURE_SPREAD) / 100.0; }
    double bagPulses() { return statusWide(CTL_REG_MEASURE_BAG_PULSES) / 100.0; }
    void connect(std::uint16_t contact) { write(contact, {CTL_INDEX_CONTACT_NORMALLY_OPEN}); }
    void setWide(std::uint16_t address, double value)
    {
        const auto raw = static_cast<std::uint32_t>(std::lround(value));
        QCOMPARE(write(address, {static_cast<std::uint16_t>(raw >> 16), static_cast<std::uint16_t>(raw)}), 0);
    }
    double filmMm() { return controller().machine().drawnMm(); }

    bool isSilent = false;

    // Lets the machine cut for this time by the clock, and measures its bags with a ruler.
    Run cut(std::uint64_t timeUs = 20'000'000)
    {
        Run run;
        double sumMm = 0.0;
        start();
        for (const std::uint64_t untilUs = controller().nowUs() + timeUs; controller().nowUs() < untilUs;) {
            controller().step();
            if (const auto& cut = controller().cut(); cut && cut->lengthUm) {
                ++run.bags;
                sumMm += *cut->lengthUm / 1000.0;
            }
        }
        run.meanMm = run.bags > 0 ? sumMm / run.bags : 0.0;
        command(CTL_COMMAND_STOP_NOW);
        while (core().motion.state != CTL_STATE_READY) {
            controller().step();
            if (const auto& cut = controller().cut(); cut && cut->lengthUm)
                run.lastMm = *cut->lengthUm / 1000.0;
        }
        return run;
    }

private:
    std::uint16_t m_session = 0;
};

MachineOptions plain()
{
    MachineOptions options;
    options.film.stretch = 0.0;
    options.products.missing = 1.0;
    return options;
}

} // namespace

class TestCommissioning : public QObject {
    Q_OBJECT

private slots:
    void wrongDataMakeWrongBags_data()
    {
        QTest::addColumn<double>("feedMm");
        QTest::addColumn<double>("filmPulses");
        QTest::addColumn<double>("knifePulses");
        QTest::addColumn<double>("reversed");
        QTest::addColumn<double>("offPercent");
        QTest::newRow("as it was told") << 150.0 << 10'000.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("film per turn") << 147.0 << 10'000.0 << 0.0 << 0.0 << -2.0;
        QTest::newRow("pulses per turn of the film") << 150.0 << 10'100.0 << 0.0 << 0.0 << -0.99;
        QTest::newRow("pulses per turn of the knife") << 150.0 << 10'000.0 << 10'100.0 << 0.0 << 1.0;
        QTest::newRow("film backward") << 150.0 << 10'000.0 << 0.0 << 2.0 << -100.0;
    }

    void wrongDataMakeWrongBags()
    {
        QFETCH(double, feedMm);
        QFETCH(double, filmPulses);
        QFETCH(double, knifePulses);
        QFETCH(double, reversed);
        QFETCH(double, offPercent);
        MachineOptions options = plain();
        options.filmFeedMm = feedMm;
        options.filmPulses = filmPulses;
        options.knifePulses = knifePulses;
        options.reversed = reversed;
        const Run run = Bench(options).cut();
        std::printf("%-30s %d bags, %.2f mm, %+.2f %%\n", QTest::currentDataTag(), run.bags, run.meanMm,
                    run.offPercent());
        QVERIFY(run.bags > 50);
        QVERIFY(std::abs(run.offPercent() - offPercent) < 0.05);
    }

    void knifeThatTurnsBackwardMakesNoBag()
    {
        MachineOptions options = plain();
        options.reversed = 1.0;
        QCOMPARE(Bench(options).cut().bags, 0);
    }

    void turnsAreCountedFromMarkToMark_data()
    {
        QTest::addColumn<unsigned>("axis");
        QTest::addColumn<double>("truth");
        QTest::newRow("knife") << unsigned(CTL_MEASURED_AXIS_KNIFE) << 10'100.0;
        QTest::newRow("film") << unsigned(CTL_MEASURED_AXIS_FILM) << 10'237.0;
        QTest::newRow("infeed") << unsigned(CTL_MEASURED_AXIS_INFEED) << 19'500.0;
    }

    // Its index marks lie 0.1 degrees off, 3 pulses of the film.
    void turnsAreCountedFromMarkToMark()
    {
        QFETCH(unsigned, axis);
        QFETCH(double, truth);
        MachineOptions options = plain();
        options.knifePulses = 10'100.0;
        options.filmPulses = 10'237.0;
        options.flightPulses = 19'500.0;
        Bench bench(options);
        bench.connect(CTL_REG_SIGNAL_FILM_INDEX_CONTACT);
        bench.connect(CTL_REG_SIGNAL_INFEED_INDEX_CONTACT);
        QCOMPARE(bench.measure(axis, 5), CTL_REFUSAL_NONE);
        QCOMPARE(bench.core().motion.state, CTL_STATE_READY);
        QCOMPARE(bench.state(), CTL_MEASURE_STATE_DONE);
        QCOMPARE(bench.status(CTL_REG_MEASURE_TURNS), 5);
        QCOMPARE(bench.status(CTL_REG_MEASURE_AXIS), axis);
        std::printf("%-8s truly %.0f pulses, measured %.2f, spread %.2f\n", QTest::currentDataTag(), truth,
                    bench.pulses(), bench.spread());
        QVERIFY(std::abs(bench.pulses() - truth) < truth * 0.0005);
        QVERIFY(bench.spread() < truth * 0.002);
    }

    // Each remedy beside its disturbance of wrongDataMakeWrongBags().
    void measuredDataMakeRightBags()
    {
        MachineOptions options = plain();
        options.knifePulses = 10'100.0;
        options.filmPulses = 10'237.0;
        options.filmFeedMm = 147.0;
        options.film.stretch = 0.004;
        Bench bench(options);
        const Run before = bench.cut();
        bench.connect(CTL_REG_SIGNAL_FILM_INDEX_CONTACT);
        bench.measure(CTL_MEASURED_AXIS_KNIFE, 5);
        bench.installFor(std::lround(bench.pulses()));
        bench.measure(CTL_MEASURED_AXIS_FILM, 5);
        bench.setWide(CTL_REG_PARAMETER_FILM_PULSES, bench.pulses());
        // The ruler measures the last bag to 0.5 mm.
        double rulerMm = 0.0;
        bench.start();
        for (int bags = 0; bags < 8;) {
            bench.controller().step();
            if (const auto& cut = bench.controller().cut(); cut && cut->lengthUm) {
                rulerMm = std::round(*cut->lengthUm / 500.0) / 2.0;
                ++bags;
            }
        }
        bench.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        const double turns = bench.bagPulses() / bench.statusWide(CTL_REG_PARAMETER_FILM_PULSES);
        bench.runUntilState(CTL_STATE_READY);
        bench.setWide(CTL_REG_PARAMETER_FILM_FEED, rulerMm / turns * 1000.0);
        const Run after = bench.cut();
        std::printf("bags %+.2f %% before, %+.2f %% behind\n", before.offPercent(), after.offPercent());
        QVERIFY(std::abs(before.offPercent()) > 2.0);
        QVERIFY(std::abs(after.offPercent()) < 0.3);
    }

    void directionIsSeenAndReversed_data()
    {
        QTest::addColumn<unsigned>("axis");
        QTest::newRow("knife") << unsigned(CTL_MEASURED_AXIS_KNIFE);
        QTest::newRow("film") << unsigned(CTL_MEASURED_AXIS_FILM);
        QTest::newRow("infeed") << unsigned(CTL_MEASURED_AXIS_INFEED);
    }

    void directionIsSeenAndReversed()
    {
        QFETCH(unsigned, axis);
        MachineOptions options = plain();
        options.reversed = 1u << axis;
        Bench bench(options);
        const controller::Machine& machine = bench.controller().machine();
        const auto place = [&] {
            return axis == CTL_MEASURED_AXIS_KNIFE  ? machine.shaftDegrees() / 360.0
                   : axis == CTL_MEASURED_AXIS_FILM ? bench.filmMm() / 150.0
                                                    : machine.infeedTurns();
        };
        const auto way = [&] {
            const double before = place();
            bench.measure(axis, 0);
            return place() - before;
        };
        const double wrong = way();
        QCOMPARE(bench.state(), CTL_MEASURE_STATE_DONE);
        QVERIFY2(wrong < -0.24 && wrong > -0.30, qPrintable(QString::number(wrong)));
        const std::int64_t commanded = bench.core().motion.commanded;
        const auto reversed = static_cast<std::uint16_t>(CTL_REG_SIGNAL_KNIFE_REVERSED + axis);
        QCOMPARE(bench.write(reversed, {1}), 0);
        const double standing = place();
        bench.run(1'000'000);
        QCOMPARE(bench.core().motion.fault, 0);
        QVERIFY(std::abs(place() - standing) < 0.0005);
        QCOMPARE(bench.core().motion.commanded, commanded);
        const double right = way();
        QVERIFY2(right > 0.24 && right < 0.30, qPrintable(QString::number(right)));
        const Run run = bench.cut();
        QVERIFY(std::abs(run.offPercent()) < 0.05);
        QCOMPARE(bench.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, bench.core().banks.active_crc),
                 CTL_REFUSAL_NONE);
        bench.controller().restart();
        QVERIFY(way() > 0.24);
    }

    void reversalWaitsForStandstill()
    {
        Bench bench(plain());
        bench.start();
        bench.run(1'000'000);
        QCOMPARE(bench.write(CTL_REG_SIGNAL_FILM_REVERSED, {1}), 0);
        const double before = bench.filmMm();
        bench.run(1'000'000);
        QVERIFY(bench.filmMm() > before + 1000.0);
        bench.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(bench.runUntilState(CTL_STATE_READY));
        bench.run(100'000);
        QCOMPARE(bench.core().reversed, 1u << CTL_MEASURED_AXIS_FILM);
        QVERIFY(!bench.core().motion.in_phase);
    }

    void whatEndsAMeasurement_data()
    {
        QTest::addColumn<int>("what");
        QTest::addColumn<unsigned>("axis");
        QTest::addColumn<unsigned>("reason");
        static constexpr const char* axes[] = {"knife", "film", "infeed"};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const auto row = [axis](const char* name, int what, unsigned reason) {
                QTest::addRow("%s, %s", axes[axis], name) << what << axis << reason;
            };
            row("emergency stop", CTL_INPUT_BIT_EMERGENCY_STOP, CTL_REFUSAL_EMERGENCY_STOP);
            row("door", CTL_INPUT_BIT_DOOR, CTL_REFUSAL_DOOR_OPEN);
            row("drive alarm", CTL_INPUT_BIT_DRIVE_ALARM, CTL_REFUSAL_DRIVE_ALARM);
            row("Stop button", CTL_INPUT_BIT_STOP_BUTTON, CTL_REFUSAL_NONE);
            row("lost line", -1, CTL_REFUSAL_HEARTBEAT_LOST);
            row("Stop", -2, CTL_REFUSAL_NONE);
        }
    }

    void whatEndsAMeasurement()
    {
        QFETCH(int, what);
        QFETCH(unsigned, axis);
        QFETCH(unsigned, reason);
        Bench bench(plain());
        bench.connect(CTL_REG_SIGNAL_FILM_INDEX_CONTACT);
        bench.connect(CTL_REG_SIGNAL_INFEED_INDEX_CONTACT);
        const auto settings = [&] { return bench.read(CTL_REG_PARAMETER_FILM_FEED, 10); };
        const Registers before = settings();
        QCOMPARE(bench.measure(axis, 5,
                               [&] {
                                   QCOMPARE(bench.state(), CTL_MEASURE_STATE_MOVING);
                                   if (what >= 0)
                                       bench.controller().machine().setInput(static_cast<unsigned>(what),
                                                                             true);
                                   else if (what == -1)
                                       bench.isSilent = true;
                                   else
                                       bench.command(CTL_COMMAND_STOP_AT_CYCLE_END);
                               }),
                 CTL_REFUSAL_NONE);
        QCOMPARE(bench.state(), CTL_MEASURE_STATE_ENDED);
        QCOMPARE(bench.reason(), reason);
        QVERIFY(ctl_motion_standstill(&bench.core().motion));
        const double filmMm = bench.filmMm();
        const double shaft = bench.controller().machine().shaftDegrees();
        const double infeed = bench.controller().machine().infeedTurns();
        bench.run(3'000'000);
        QCOMPARE(bench.filmMm(), filmMm);
        QCOMPARE(bench.controller().machine().shaftDegrees(), shaft);
        QCOMPARE(bench.controller().machine().infeedTurns(), infeed);
        QCOMPARE(settings(), before);
    }

    void whatRefusesAMeasurement()
    {
        Bench bench(plain());
        const auto asks = [&](unsigned axis, unsigned turns) { return bench.measure(axis, turns); };
        QCOMPARE(asks(CTL_MEASURED_AXIS_FILM, 5), CTL_REFUSAL_NO_INDEX);
        QCOMPARE(asks(CTL_MEASURED_AXIS_INFEED, 5), CTL_REFUSAL_NO_INDEX);
        QCOMPARE(asks(CTL_MEASURED_AXIS_FILM, 0), CTL_REFUSAL_NONE);
        QCOMPARE(asks(3, 5), CTL_REFUSAL_BAD_ARGUMENT);
        QCOMPARE(asks(CTL_MEASURED_AXIS_KNIFE, 21), CTL_REFUSAL_BAD_ARGUMENT);
        bench.controller().machine().setInput(CTL_INPUT_BIT_DOOR, true);
        bench.run(100'000);
        QCOMPARE(asks(CTL_MEASURED_AXIS_KNIFE, 5), CTL_REFUSAL_DOOR_OPEN);
        bench.controller().machine().setInput(CTL_INPUT_BIT_DOOR, false);
        bench.run(2'000'000);
        QCOMPARE(bench.command(CTL_COMMAND_MEASURE, CTL_MEASURED_AXIS_KNIFE, 5), CTL_REFUSAL_HEARTBEAT_LOST);
        bench.start();
        QCOMPARE(asks(CTL_MEASURED_AXIS_KNIFE, 5), CTL_REFUSAL_NOT_STANDSTILL);
        Bench empty(plain());
        empty.core().banks.has_active = false;
        QCOMPARE(empty.measure(CTL_MEASURED_AXIS_KNIFE, 5), CTL_REFUSAL_NO_ACTIVE_PROGRAM);
        Rig press;
        press.install(PressImage().registers());
        press.heartbeat();
        QCOMPARE(press.command(CTL_COMMAND_MEASURE, CTL_MEASURED_AXIS_KNIFE, 5), CTL_REFUSAL_NO_INDEX);
        QCOMPARE(press.command(CTL_COMMAND_MEASURE, CTL_MEASURED_AXIS_FILM, 0), CTL_REFUSAL_NO_BAGS);
    }

    void jawsThatHoldTheFilmRefuse()
    {
        Bench bench(plain());
        bench.write(CTL_REG_PARAMETER_JAWS_BEFORE, {2000, 2000});
        // An emergency stop leaves the knife where it is.
        for (std::uint64_t tries = 0; tries < 20 && ctl_motion_jaws_are_open(&bench.core().motion); ++tries) {
            bench.start();
            bench.run(2'000'000 + tries * 30'000);
            bench.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
            bench.runUntilState(CTL_STATE_READY);
            bench.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
            bench.run(3'000'000);
        }
        QCOMPARE(bench.measure(CTL_MEASURED_AXIS_FILM, 0), CTL_REFUSAL_JAWS_CLOSED);
        QCOMPARE(bench.measure(CTL_MEASURED_AXIS_INFEED, 0), CTL_REFUSAL_NONE);
    }

    // A sensor that sees nothing.
    void noMarkComes()
    {
        MachineOptions options = plain();
        options.filmPulses = 1e6;
        Bench bench(options);
        bench.connect(CTL_REG_SIGNAL_FILM_INDEX_CONTACT);
        bench.measure(CTL_MEASURED_AXIS_FILM, 5);
        QCOMPARE(bench.state(), CTL_MEASURE_STATE_ENDED);
        QCOMPARE(bench.reason(), CTL_REFUSAL_NO_INDEX_MARK);
        QCOMPARE(bench.pulses(), 0.0);
    }

    // The film between two cuts is not known over a jog, which may cut unseen.
    void bagIsKnownBetweenTwoCuts()
    {
        Bench bench(plain());
        QCOMPARE(bench.bagPulses(), 0.0);
        const Run run = bench.cut(5'000'000);
        QVERIFY(std::abs(bench.bagPulses() / 10'000.0 * 150.0 - run.lastMm) < 0.1);
        QCOMPARE(bench.statusWide(CTL_REG_MEASURE_BAG), bench.core().packer.bags);
        bench.measure(CTL_MEASURED_AXIS_FILM, 0);
        bench.start();
        for (int cuts = 0; cuts < 1;) {
            bench.controller().step();
            cuts += bench.controller().cut() ? 1 : 0;
        }
        QCOMPARE(bench.bagPulses(), 0.0);
    }
};

CAMPANEL_TEST(TestCommissioning)

} // namespace test_commissioning

#include "test_commissioning.moc"
