// SPDX-License-Identifier: Apache-2.0
// The pulses of the date coder: one for each product, at its place before the cut, whatever happens to line,
// program and trims. The simulated machine counts products and pulses by itself.
#include "coder_prints.h"
#include "rig.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace test_coder {

using namespace campanel::test;
using campanel::controller::BagCut;
using campanel::controller::CoderPrints;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr double bagMm = 250.0;
constexpr double allowedMm = 0.2;
constexpr unsigned pulseBit = 1u << CTL_OUTPUT_BIT_CODER_PULSE;
enum class Master { Clock, Shaft, Wheel };

MachineOptions calm(Master master)
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.products.laySlipMm = 0.0;
    options.products.eyeNoiseMm = 0.0;
    if (master == Master::Clock)
        return options;
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = bagMm * 1e6 / cycleUs;
    options.shaft.drivesFilm = master == Master::Wheel;
    return options;
}

BankImage bankOf(std::uint32_t bagUm)
{
    BankImage image = camBank(10000, 1, cycleTicks);
    image.bagLengthUm = bagUm;
    return image;
}

class Line : public Rig {
public:
    Line(const MachineOptions& options, Master master, bool marks, double placeMm)
        : Rig(options)
        , prints(placeMm)
        , m_seesHand(marks && placeMm < bagMm / 2)
    {
        controller().onStep = [this] { look(); };
        install(bankOf(250'000));
        setParameter(CTL_REG_PARAMETER_MARK_TRACKING, marks ? 1 : 0);
        setWide(CTL_REG_PARAMETER_MARK_DISTANCE, options.film.markDistanceMm);
        setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
        setParameter(CTL_REG_SIGNAL_CODER_PLACE, static_cast<std::uint16_t>(std::lround(placeMm * 10)));
        setParameter(CTL_REG_PARAMETER_JAM_DETECTION, 1);
        setParameter(CTL_REG_PARAMETER_JAM_STOP_TIME, 20);
        setParameter(CTL_REG_PARAMETER_JAM_BACK, 6000);
        setParameter(CTL_REG_PARAMETER_JAWS_BEFORE, 2'000);
        setParameter(CTL_REG_PARAMETER_JAWS_BEHIND, 2'000);
        if (master != Master::Clock) {
            write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
            write(CTL_REG_MASTER_PLACE,
                  {static_cast<std::uint16_t>(master == Master::Wheel ? CTL_MASTER_PLACE_WHEEL
                                                                      : CTL_MASTER_PLACE_SHAFT)});
            run(500'000);
        }
        command(CTL_COMMAND_START);
        run(20 * cycleUs);
        if (master == Master::Wheel)
            prints.forgetUnseen();
    }

    int set(std::uint16_t address, double mm)
    {
        return write(address, {static_cast<std::uint16_t>(std::lround(mm * 1000))});
    }
    int setWide(std::uint16_t address, double mm)
    {
        const auto um = static_cast<std::uint32_t>(std::lround(mm * 1000));
        return write(address, {static_cast<std::uint16_t>(um >> 16), static_cast<std::uint16_t>(um)});
    }
    int setSpeed(std::uint16_t percent) { return write(CTL_REG_HAND_SPEED, {percent}); }
    void jog(std::uint16_t keys, std::uint64_t timeUs)
    {
        for (std::uint64_t us = 0; us < timeUs; us += 50'000) {
            heartbeat(keys);
            run(50'000);
        }
        heartbeat();
        run(500'000);
    }
    // Waits for the end of what is ending.
    void runUntilStands()
    {
        while (core().motion.state == CTL_STATE_STOPPING || core().motion.state == CTL_STATE_HOMING)
            run(10'000);
    }
    // Cuts of the next bags are moved. A pulse half a bag before its cut, or behind it, knows of that, but
    // not where a skipped cut would have been.
    void disturb(std::uint32_t bags = 8) { m_disturbedTo = std::max(m_disturbedTo, m_cuts + bags); }

    CoderPrints prints;

private:
    void look()
    {
        if (const auto pulse = controller().machine().takeCoderPulseMm())
            prints.takePulse(*pulse);
        if (controller().cutByHand())
            prints.takeCut(*controller().cutByHand(), 0, bagMm);
        if (!controller().cut())
            return;
        ++m_cuts;
        const ctl_last_cut& last = core().packer.last_cut;
        prints.takeCut(*controller().cut(), placedLengths(),
                       static_cast<double>(last.set_um) / 1000.0 / last.bags);
    }
    // Nobody knows at the pulse that a jam or a start will move the cut, that it will miss its mark, or where
    // the marks of the next program are.
    int placedLengths()
    {
        const ctl_last_cut& last = core().packer.last_cut;
        if (last.jammed || !controller().cut()->lengthUm || !hitsMark() || (last.changed && last.scrap))
            return 0;
        if (m_cuts > m_disturbedTo && !last.scrap)
            return static_cast<int>(last.bags);
        return m_seesHand ? 1 : 0;
    }
    bool hitsMark() { return std::abs(ctl_packer_um(&core().packer, core().packer.last_cut.error)) < 40; }
    const bool m_seesHand;
    std::uint32_t m_cuts = 0;
    std::uint32_t m_disturbedTo = 0;
};

} // namespace

class TestCoder : public QObject {
    Q_OBJECT

private slots:
    void eachProductAtItsPlace_data();
    void eachProductAtItsPlace();
    void marksOnStretchedFilmTellThePlace_data();
    void marksOnStretchedFilmTellThePlace();
    void followsTheHand_data();
    void followsTheHand();
    void noPulseIsLostOrDoubled_data();
    void noPulseIsLostOrDoubled();
    void pulseHasItsLength();
    void pulseBeforeTheProductIsRefused();
    void readyIsWhatTheGateSays();
    void requestUntilAProductComes();
};

void TestCoder::eachProductAtItsPlace_data()
{
    QTest::addColumn<int>("master");
    QTest::addColumn<bool>("marks");
    QTest::addColumn<double>("placeMm");
    for (const double placeMm : {0.0, 60.0, 310.5, 600.0, -40.0, -400.0}) {
        const auto name = [placeMm](const char* line) {
            return QStringLiteral("%1, %2 mm").arg(QLatin1String(line)).arg(placeMm).toLatin1();
        };
        QTest::newRow(name("clock, marks")) << int(Master::Clock) << true << placeMm;
        QTest::newRow(name("clock, no marks")) << int(Master::Clock) << false << placeMm;
        QTest::newRow(name("shaft")) << int(Master::Shaft) << true << placeMm;
        if (placeMm >= 0.0)
            QTest::newRow(name("wheel")) << int(Master::Wheel) << true << placeMm;
    }
}

void TestCoder::eachProductAtItsPlace()
{
    QFETCH(int, master);
    QFETCH(bool, marks);
    QFETCH(double, placeMm);
    MachineOptions options = calm(static_cast<Master>(master));
    options.products.missing = 0.1;
    Line line(options, static_cast<Master>(master), marks, placeMm);
    line.disturb();
    line.run(200 * cycleUs);
    const CoderPrints& prints = line.prints;
    QVERIFY(prints.placed() > 100);
    QVERIFY2(prints.farthestMm() < allowedMm, qPrintable(QString::number(prints.farthestMm())));
}

void TestCoder::marksOnStretchedFilmTellThePlace_data()
{
    QTest::addColumn<double>("placeMm");
    QTest::addColumn<double>("sensorMm");
    for (const double placeMm : {100.0, 400.0, 500.0, 600.0}) {
        for (const double sensorMm : {900.0, 300.0})
            QTest::addRow("%g mm, sensor at %g mm", placeMm, sensorMm) << placeMm << sensorMm;
    }
}

// The film starts off its marks, and is longer than the program cuts it, by so much that a place by bag
// lengths alone would be off.
void TestCoder::marksOnStretchedFilmTellThePlace()
{
    QFETCH(double, placeMm);
    QFETCH(double, sensorMm);
    MachineOptions options = calm(Master::Clock);
    options.film.stretch = 0.003;
    options.film.misplacedMm = 60.0;
    options.film.markDistanceMm = sensorMm;
    Line line(options, Master::Clock, true, placeMm);
    line.run(400 * cycleUs);
    QVERIFY(line.prints.placed() > 100);
    QVERIFY2(line.prints.farthestMm() < allowedMm, qPrintable(QString::number(line.prints.farthestMm())));
}

void TestCoder::followsTheHand_data()
{
    QTest::addColumn<int>("master");
    QTest::addColumn<bool>("marks");
    QTest::newRow("clock, marks") << int(Master::Clock) << true;
    QTest::newRow("clock, no marks") << int(Master::Clock) << false;
    QTest::newRow("shaft") << int(Master::Shaft) << true;
    QTest::newRow("wheel") << int(Master::Wheel) << true;
}

// Half a bag before its cut the pulse knows of each trim: no bag is excepted.
void TestCoder::followsTheHand()
{
    QFETCH(int, master);
    QFETCH(bool, marks);
    Line line(calm(static_cast<Master>(master)), static_cast<Master>(master), marks, 100.0);
    line.disturb();
    std::mt19937_64 random(7);
    const auto upTo = [&random](double mm) {
        return std::uniform_real_distribution<double>(-mm, mm)(random);
    };
    for (int i = 0; i < 60; ++i) {
        QCOMPARE(line.set(CTL_REG_HAND_CUT, upTo(10.0)), 0);
        line.run(random() % (4 * cycleUs));
        QCOMPARE(line.set(CTL_REG_HAND_PRODUCT, upTo(20.0)), 0);
        QCOMPARE(line.set(CTL_REG_HAND_LENGTH, upTo(5.0)), 0);
        QCOMPARE(line.setSpeed(static_cast<std::uint16_t>(20 + random() % 81)), 0);
        if (!marks) // the cut of a bag that has its pulse goes with the speed
            line.disturb(2);
        line.run(random() % (8 * cycleUs));
    }
    QVERIFY2(line.prints.placed() > 80, qPrintable(QString::number(line.prints.placed())));
    QVERIFY2(line.prints.farthestMm() < allowedMm, qPrintable(QString::number(line.prints.farthestMm())));
}

void TestCoder::noPulseIsLostOrDoubled_data()
{
    QTest::addColumn<int>("master");
    QTest::addColumn<bool>("marks");
    QTest::addColumn<double>("placeMm");
    QTest::newRow("clock, marks, before the cut") << int(Master::Clock) << true << 60.0;
    QTest::newRow("clock, marks, far before") << int(Master::Clock) << true << 500.0;
    QTest::newRow("clock, marks, behind the cut") << int(Master::Clock) << true << -300.0;
    QTest::newRow("clock, no marks, before the cut") << int(Master::Clock) << false << 60.0;
    QTest::newRow("clock, no marks, far before") << int(Master::Clock) << false << 600.0;
    QTest::newRow("shaft, before the cut") << int(Master::Shaft) << true << 60.0;
    QTest::newRow("wheel, before the cut") << int(Master::Wheel) << true << 60.0;
}

// Products are missing, off their places and too near to a cut; trims, speed and program change, the run is
// stopped in mid-bag, jogged, ended by the emergency stop and by a jam. A pulse too many or too few would put
// all later ones on the wrong product, a bag away.
void TestCoder::noPulseIsLostOrDoubled()
{
    QFETCH(int, master);
    QFETCH(bool, marks);
    QFETCH(double, placeMm);
    bool isSet = false;
    const int cases = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES", &isSet);
    const std::uint32_t wanted = isSet ? static_cast<std::uint32_t>(cases) / 7 : 600;
    MachineOptions options = calm(static_cast<Master>(master));
    options.drive.inertiaKgM2 = 0.0003; // the bank of the tests accelerates it by jerks
    options.products.misplaced = 0.02;
    options.products.missing = 0.05;
    Line line(options, static_cast<Master>(master), marks, placeMm);
    std::mt19937_64 random(static_cast<std::uint64_t>(master) + 11);
    const auto upTo = [&random](double mm) {
        return std::uniform_real_distribution<double>(-mm, mm)(random);
    };
    const bool hasWheel = static_cast<Master>(master) == Master::Wheel;
    std::uint16_t session = 1;
    int jams = 0;
    while (line.prints.products() < wanted) {
        const auto what = random() % 9;
        if (what < 4 || !marks)
            line.disturb();
        switch (what) {
        case 0:
            line.set(CTL_REG_HAND_CUT, upTo(10.0));
            break;
        case 1:
            line.set(CTL_REG_HAND_PRODUCT, upTo(20.0));
            break;
        case 2:
            line.set(CTL_REG_HAND_LENGTH, upTo(5.0));
            break;
        case 3:
            line.setSpeed(static_cast<std::uint16_t>(20 + random() % 81));
            break;
        case 4:
            line.command(CTL_COMMAND_STOP_NOW);
            break;
        case 5:
            line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
            break;
        case 6:
            if (!hasWheel) {
                ++session;
                const Registers image = bankOf(session % 2 == 0 ? 240'000 : 250'000).registers();
                QCOMPARE(line.download(image, session), CTL_TRANSFER_RESULT_ACCEPTED);
                line.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, session);
            }
            break;
        case 7:
            line.controller().machine().jaws().setBlocked(true);
            line.run(2 * cycleUs);
            line.controller().machine().jaws().setBlocked(false);
            break;
        default:
            line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
            line.run(2000);
            line.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
            break;
        }
        line.run(random() % (20 * cycleUs));
        line.runUntilStands();
        line.run(2'100'000);
        if (line.core().motion.state == CTL_STATE_FAULT) {
            jams += line.core().motion.fault == 1u << CTL_FAULT_BIT_JAM ? 1 : 0;
            QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
            line.run(500'000);
        }
        if (line.core().motion.state == CTL_STATE_READY) {
            if (random() % 3 == 0)
                line.jog(1u << CTL_JOG_BIT_FORWARD, 300'000);
            else if (random() % 2 == 0 && !hasWheel)
                line.command(CTL_COMMAND_JOG_BAG);
            line.run(2'100'000);
            // A bag by hand is slow, and skipped cuts make it longer: once in 13 000 products over a minute.
            QVERIFY(line.runUntilState(CTL_STATE_READY, 300'000'000));
            const std::uint16_t refusal = line.command(CTL_COMMAND_START);
            QVERIFY2(refusal == CTL_REFUSAL_NONE, qPrintable(QString::number(refusal)));
        }
        if (!marks)
            line.disturb();
        QVERIFY(line.core().motion.state != CTL_STATE_FAULT);
        line.run(12 * cycleUs);
    }
    const CoderPrints& prints = line.prints;
    qInfo("%u products, %u pulses, %u in their places, the farthest %.3f mm off, %d jams, %zu ahead, %zu "
          "waiting",
          prints.products(), prints.pulses(), prints.placed(), prints.farthestMm(), jams, prints.ahead(),
          prints.waiting());
    QVERIFY(prints.placed() > wanted / 10);
    QVERIFY2(prints.farthestMm() < allowedMm, qPrintable(QString::number(prints.farthestMm())));
    QVERIFY(prints.ahead() <= 4 && prints.waiting() <= 3);
}

void TestCoder::pulseHasItsLength()
{
    Line line(calm(Master::Clock), Master::Clock, true, 60.0);
    for (const std::uint16_t ms : std::array<std::uint16_t, 4>{1, 20, 150, 1000}) {
        line.setParameter(CTL_REG_SIGNAL_CODER_PULSE, ms);
        line.run(2 * cycleUs);
        const std::uint32_t before = line.prints.pulses();
        std::uint64_t on = 0;
        std::uint64_t longest = 0;
        for (std::uint64_t us = 0; us < 20 * cycleUs; us += 250) {
            line.controller().step();
            on = (line.core().io.outputs & pulseBit) != 0 ? on + 250 : 0;
            longest = std::max(longest, on);
        }
        // One that is longer than a cycle ends before the next one.
        const std::uint64_t expected = ms == 1000 ? cycleUs - 5000 : 1000u * ms;
        QVERIFY2(longest + 2000 >= expected && longest <= expected + 2000,
                 qPrintable(QString::number(longest)));
        QVERIFY(line.prints.pulses() - before >= 19);
    }
}

void TestCoder::pulseBeforeTheProductIsRefused()
{
    Rig rig;
    rig.install(bankOf(250'000));
    rig.heartbeat();
    rig.setParameter(CTL_REG_SIGNAL_CODER_PLACE, 30'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_CODER_TOO_FAR);
    rig.setParameter(CTL_REG_SIGNAL_CODER_PLACE, static_cast<std::uint16_t>(0x10000 - 5000));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
}

void TestCoder::readyIsWhatTheGateSays()
{
    const auto isReady = [](Rig& rig) {
        rig.run(50'000);
        return (rig.core().io.outputs & 1u << CTL_OUTPUT_BIT_READY) != 0;
    };
    Rig rig;
    QVERIFY(!isReady(rig)); // no program
    rig.install(bankOf(250'000));
    rig.heartbeat();
    QVERIFY(isReady(rig));
    for (const unsigned input :
         {CTL_INPUT_BIT_STOP_BUTTON, CTL_INPUT_BIT_DOOR, CTL_INPUT_BIT_NEXT_MACHINE, CTL_INPUT_BIT_CODER}) {
        rig.controller().machine().setInput(input, true);
        rig.run(150'000);
        QVERIFY(!isReady(rig));
        rig.controller().machine().setInput(input, false);
        rig.run(150'000);
        QVERIFY(isReady(rig));
    }
    rig.setParameter(CTL_REG_SIGNAL_CODER_PLACE, 30'000);
    QVERIFY(!isReady(rig));
    rig.setParameter(CTL_REG_SIGNAL_CODER_PLACE, 0);
    rig.setParameter(CTL_REG_PARAMETER_PERMIT_NEEDED, 1);
    rig.heartbeat(0, 0);
    QVERIFY(!isReady(rig));
    rig.heartbeat(0, (2u << CTL_PERMIT_BIT_LAST) - 1u);
    QVERIFY(isReady(rig));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(!isReady(rig));
    ctl_motion_fault(&rig.core().motion, CTL_FAULT_BIT_FOLLOWING_ERROR);
    QVERIFY(!isReady(rig));
}

void TestCoder::requestUntilAProductComes()
{
    constexpr unsigned request = 1u << CTL_OUTPUT_BIT_REQUEST;
    MachineOptions options = calm(Master::Clock);
    options.products.missing = 0.2;
    Line line(options, Master::Clock, true, 60.0);
    std::uint32_t rises = 0;
    std::uint32_t wrong = 0;
    bool before = true;
    const std::uint32_t first = line.core().packer.products.total;
    for (std::uint64_t us = 0; us < 200 * cycleUs; us += 250) {
        line.controller().step();
        const bool now = (line.core().io.outputs & request) != 0;
        rises += now && !before ? 1u : 0u;
        wrong += now && line.core().packer.products.covered && before ? 1u : 0u; // for up to 20 ms
        before = now;
    }
    const std::uint32_t products = line.core().packer.products.total - first;
    QVERIFY(products > 100);
    // It goes off once for each product: an empty place leaves it on.
    QVERIFY2(rises + 1 >= products && rises <= products + 1,
             qPrintable(QString("%1 %2").arg(rises).arg(products)));
    QVERIFY2(wrong <= 85 * products, qPrintable(QString::number(wrong)));
    line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    line.run(25'000);
    QVERIFY((line.core().io.outputs & request) == 0);
}

CAMPANEL_TEST(TestCoder)

} // namespace test_coder

#include "test_coder.moc"
