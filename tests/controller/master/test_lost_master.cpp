// SPDX-License-Identifier: Apache-2.0
// An encoder that cannot be trusted ends the run with a fault of its own, soon.
#include "rig.h"

#include "base/ctl_words.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_lost_master {

using namespace campanel::test;
using campanel::controller::LineShaft;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 8'000'000; // 60 a minute
constexpr double bagMm = 250.0;

MachineOptions onLine(bool drivesFilm)
{
    MachineOptions options;
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = bagMm;
    options.shaft.drivesFilm = drivesFilm;
    options.shaft.jitterCounts = 0.5;
    options.shaft.ripple = 0.01;
    return options;
}

class Line : public Rig {
public:
    explicit Line(bool drivesFilm = false, std::uint16_t slipLimit = 200)
        : Rig(onLine(drivesFilm))
    {
        BankImage bank = camBank(10'000, 1, cycleTicks);
        bank.bagLengthUm = 250'000;
        install(bank);
        write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        write(CTL_REG_MASTER_PLACE,
              {static_cast<std::uint16_t>(drivesFilm ? CTL_MASTER_PLACE_WHEEL : CTL_MASTER_PLACE_SHAFT)});
        write(CTL_REG_MASTER_INDEX_LIMIT, {2});
        write(CTL_REG_MASTER_SLIP_LIMIT, {slipLimit});
        run(500'000);
        start();
    }

    bool engages()
    {
        for (int i = 0; i < 2000 && status(CTL_REG_MASTER_STATUS_STATE) != CTL_MASTER_STATE_ENGAGED; ++i)
            run(10'000);
        return status(CTL_REG_MASTER_STATUS_STATE) == CTL_MASTER_STATE_ENGAGED;
    }

    bool tracks()
    {
        for (int i = 0; i < 200 && core().packer.marks.state != CTL_MARK_STATE_TRACKING; ++i)
            run(500'000);
        run(5'000'000);
        return core().packer.marks.state == CTL_MARK_STATE_TRACKING;
    }

    LineShaft& shaft() { return controller().machine().shaft(); }

    // Returns the film that passes until the fault, or none within 20 m.
    std::optional<double> filmToFault()
    {
        const double from = shaft().positionMm();
        while (core().motion.state != CTL_STATE_FAULT) {
            if (shaft().positionMm() - from > 20'000.0)
                return std::nullopt;
            controller().step();
        }
        return shaft().positionMm() - from;
    }
    std::uint16_t faults() { return status(CTL_REG_STATUS_FAULT); }
};

constexpr unsigned bit(unsigned number)
{
    return 1u << number;
}

} // namespace

class TestLostMaster : public QObject {
    Q_OBJECT

private slots:
    void anIllegalTransitionIsAFault();
    void aJumpOfTheCountsIsAFault();
    void lostCountsAreAFaultAtTheIndexMark();
    void withoutAnIndexMarkNobodyKnows();
    void aWheelThatSlipsIsAFaultAtTheNextMark_data();
    void aWheelThatSlipsIsAFaultAtTheNextMark();
    void slipMayBeIgnored();
    void falseAndMissingMarksAreNoSlip();
    void nothingIsAFaultOfAGoodEncoder_data();
    void nothingIsAFaultOfAGoodEncoder();
    void aStartBehindTheFaultGoesOn();
    void swappedWiresAreAFaultAfterABag_data();
    void swappedWiresAreAFaultAfterABag();
    void aMasterMayCreepBackByLessThanABag();
    void aCamThatMayGoBackFollows();
};

void TestLostMaster::anIllegalTransitionIsAFault()
{
    Line line;
    QVERIFY(line.engages());
    line.shaft().setNoise(0.2);
    const auto film = line.filmToFault();
    QVERIFY(film && *film < 3.0);
    QCOMPARE(line.faults(), bit(CTL_FAULT_BIT_MASTER_SIGNAL));
    QVERIFY(line.status(CTL_REG_MASTER_STATUS_INPUT_ERRORS) > 0);
}

void TestLostMaster::aJumpOfTheCountsIsAFault()
{
    Line line;
    QVERIFY(line.engages());
    const std::int64_t before = line.core().motion.commanded;
    line.shaft().jump();
    const auto film = line.filmToFault();
    QVERIFY(film && *film < 3.0);
    QCOMPARE(line.faults(), bit(CTL_FAULT_BIT_MASTER_SPEED));
    QVERIFY(line.core().motion.commanded - before < 3 * 10'000 / 250); // nor has the knife jumped
}

void TestLostMaster::lostCountsAreAFaultAtTheIndexMark()
{
    Line line;
    QVERIFY(line.engages());
    line.run(5'000'000);
    QCOMPARE(line.read(CTL_REG_MASTER_STATUS_INDEX_ERROR, 1).at(0), 0);
    line.shaft().setLost(3);
    const auto film = line.filmToFault();
    QVERIFY(film && *film < 1.02 * bagMm); // one revolution
    QCOMPARE(line.faults(), bit(CTL_FAULT_BIT_MASTER_COUNTS));
    QCOMPARE(static_cast<std::int16_t>(line.read(CTL_REG_MASTER_STATUS_INDEX_ERROR, 1).at(0)), -3);
}

void TestLostMaster::withoutAnIndexMarkNobodyKnows()
{
    Line line;
    line.write(CTL_REG_MASTER_INDEX_LIMIT, {0});
    QVERIFY(line.engages());
    line.shaft().setLost(3);
    QVERIFY(!line.filmToFault());
}

void TestLostMaster::aWheelThatSlipsIsAFaultAtTheNextMark_data()
{
    QTest::addColumn<double>("slip");
    QTest::addColumn<double>("bags");
    QTest::newRow("1 %") << 0.01 << 1.1;
    QTest::newRow("beyond the window of the marks") << 0.03 << 2.2;
    QTest::newRow("far beyond it") << 0.2 << 3.1;
    QTest::newRow("the wheel stands") << 1.0 << 5.0;
}

// At the first mark whose distance shows it, once the window of the right one has passed.
void TestLostMaster::aWheelThatSlipsIsAFaultAtTheNextMark()
{
    QFETCH(double, slip);
    QFETCH(double, bags);
    Line line(true);
    QVERIFY(line.engages());
    QVERIFY(line.tracks());
    const std::uint32_t seen = line.core().packer.marks.followed;
    while (line.core().packer.marks.followed == seen)
        line.controller().step();
    line.shaft().setSlip(slip);
    const auto film = line.filmToFault();
    QVERIFY(film.has_value());
    QVERIFY2(*film < bags * bagMm, qPrintable(QString::number(*film)));
    QCOMPARE(line.faults(), bit(CTL_FAULT_BIT_MASTER_SLIP));
}

void TestLostMaster::slipMayBeIgnored()
{
    Line line(true, 0);
    QVERIFY(line.engages());
    QVERIFY(line.tracks());
    line.shaft().setSlip(0.01);
    QVERIFY(!line.filmToFault());
}

void TestLostMaster::falseAndMissingMarksAreNoSlip()
{
    MachineOptions options = onLine(true);
    options.film.marksFalse = 0.05;
    options.film.marksMissing = 0.02;
    options.film.falseWidthMm = 0.5; // else some run into a mark, and are one print with it
    Rig rig(options);
    BankImage bank = camBank(10'000, 1, cycleTicks);
    bank.bagLengthUm = 250'000;
    rig.install(bank);
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.write(CTL_REG_MASTER_PLACE, {CTL_MASTER_PLACE_WHEEL});
    rig.run(500'000);
    rig.start();
    rig.run(1'000'000'000);
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 0);
    QVERIFY(rig.core().packer.marks.missing > 5);
    QVERIFY(rig.core().packer.marks.unexpected > 20);
}

void TestLostMaster::nothingIsAFaultOfAGoodEncoder_data()
{
    QTest::addColumn<bool>("drivesFilm");
    QTest::newRow("shaft") << false;
    QTest::newRow("wheel") << true;
}

// With stops, restarts and a way back.
void TestLostMaster::nothingIsAFaultOfAGoodEncoder()
{
    QFETCH(bool, drivesFilm);
    Line line(drivesFilm);
    QVERIFY(line.engages());
    for (int i = 0; i < 20; ++i) {
        line.run(20'000'000);
        line.shaft().setSpeed(0.0);
        line.run(1'500'000);
        line.shaft().setSpeed(-20.0);
        line.run(500'000);
        line.shaft().setSpeed(bagMm);
        QCOMPARE(line.faults(), 0);
    }
    QCOMPARE(line.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
    QCOMPARE(line.read(CTL_REG_MASTER_STATUS_INDEX_ERROR, 1).at(0), 0);
}

void TestLostMaster::aStartBehindTheFaultGoesOn()
{
    Line line;
    QVERIFY(line.engages());
    line.run(3'000'000);
    line.shaft().setLost(5);
    QVERIFY(line.filmToFault());
    line.shaft().setLost(0);
    line.run(500'000);
    QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(line.engages());
    line.run(5'000'000);
    QCOMPARE(line.faults(), 0);
}

void TestLostMaster::swappedWiresAreAFaultAfterABag_data()
{
    QTest::addColumn<bool>("drivesFilm");
    QTest::addColumn<bool>("isEngaged");
    QTest::newRow("shaft, before the start") << false << false;
    QTest::newRow("shaft, in a run") << false << true;
    QTest::newRow("wheel, before the start") << true << false;
    QTest::newRow("wheel, in a run") << true << true;
}

// And a start behind it goes on with the sign changed.
void TestLostMaster::swappedWiresAreAFaultAfterABag()
{
    QFETCH(bool, drivesFilm);
    QFETCH(bool, isEngaged);
    Line line(drivesFilm);
    line.write(CTL_REG_MASTER_INDEX_LIMIT, {0}); // wires that are swapped in a run move its place
    if (isEngaged) {
        QVERIFY(line.engages());
        line.run(3'000'000);
    } else {
        line.command(CTL_COMMAND_STOP_NOW);
        QVERIFY(line.runUntilState(CTL_STATE_READY));
    }
    line.shaft().setReversed(true);
    if (!isEngaged) {
        line.run(500'000);
        line.start();
    }
    const std::int64_t knife = line.core().motion.commanded;
    const auto film = line.filmToFault();
    QVERIFY(film.has_value());
    QVERIFY2(*film > 0.99 * bagMm && *film < 1.1 * bagMm, qPrintable(QString::number(*film)));
    QCOMPARE(line.faults(), bit(CTL_FAULT_BIT_MASTER_BACKWARD));
    QVERIFY(isEngaged || line.core().motion.commanded == knife);
    QCOMPARE(line.status(CTL_REG_IO_OUTPUTS) & 1u << CTL_OUTPUT_BIT_LINE_MAY_RUN, 0u);
    QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    line.write(CTL_REG_MASTER_REVERSED, {1});
    line.run(500'000);
    QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(line.engages());
    line.run(3'000'000);
    QCOMPARE(line.faults(), 0);
}

void TestLostMaster::aMasterMayCreepBackByLessThanABag()
{
    Line line;
    QVERIFY(line.engages());
    line.run(3'000'000);
    line.shaft().setSpeed(0.0);
    line.run(1'500'000);
    const double from = line.shaft().positionMm();
    line.shaft().setSpeed(-20.0);
    while (line.shaft().positionMm() > from - 0.95 * bagMm)
        line.run(1000);
    QCOMPARE(line.faults(), 0);
    line.shaft().setSpeed(bagMm);
    QVERIFY(line.engages());
    line.run(3'000'000);
    QCOMPARE(line.faults(), 0);
}

void TestLostMaster::aCamThatMayGoBackFollows()
{
    Rig rig(onLine(false));
    CamImage cam = sineCam(5000.0, 300.0, 400, cycleTicks / 5);
    cam.masterRampMs = 0;
    for (const bool mayGoBack : {true, false}) {
        rig.install(cam.registers());
        rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        rig.write(CTL_REG_MASTER_BACKWARD, {static_cast<std::uint16_t>(mayGoBack ? 1 : 0)});
        rig.controller().machine().shaft().setSpeed(bagMm);
        rig.run(1'500'000);
        rig.start();
        rig.run(5'000'000);
        QCOMPARE(rig.status(CTL_REG_MASTER_STATUS_STATE), CTL_MASTER_STATE_ENGAGED);
        rig.controller().machine().shaft().setSpeed(-bagMm);
        rig.run(5'000'000); // many cycles of the cam
        QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), mayGoBack ? 0u : bit(CTL_FAULT_BIT_MASTER_BACKWARD));
        if (mayGoBack) {
            rig.command(CTL_COMMAND_STOP_NOW);
            QVERIFY(rig.runUntilState(CTL_STATE_READY));
        }
    }
}

CAMPANEL_TEST(TestLostMaster)

} // namespace test_lost_master

#include "test_lost_master.moc"
