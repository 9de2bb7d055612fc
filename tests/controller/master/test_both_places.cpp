// SPDX-License-Identifier: Apache-2.0
// A packing line behind an encoder, in both of its places: marks, products, drive faults and the
// operator's speed. Change of program, park, jam and order: test_master_change, test_wheel, test_jam and
// test_order.
#include "master/place_line.h"

#include "tests/support/test_program.h"

#include <QTest>

namespace test_both_places {

using namespace campanel::test;
using namespace campanel::test::place;
using campanel::controller::MachineOptions;

namespace {

void addPlaces()
{
    QTest::addColumn<bool>("drivesFilm");
    QTest::newRow("shaft") << false;
    QTest::newRow("wheel") << true;
}

// Returns how many bags were cut, and fails where the knife went through a product.
int cutsIn(Line& line, std::uint64_t timeUs)
{
    int cuts = 0;
    const std::uint64_t untilUs = line.controller().nowUs() + timeUs;
    while (line.controller().nowUs() < untilUs) {
        line.controller().step();
        const auto& cut = line.controller().cut();
        if (!cut)
            continue;
        ++cuts;
        if (cut->throughProduct)
            return -1;
    }
    return cuts;
}

} // namespace

class TestBothPlaces : public QObject {
    Q_OBJECT

private slots:
    void cutsOnTheMarks_data() { addPlaces(); }
    void cutsOnTheMarks();
    void productsAreNotCut_data() { addPlaces(); }
    void productsAreNotCut();
    void missingProductsSaveOwnFilmAlone_data() { addPlaces(); }
    void missingProductsSaveOwnFilmAlone();
    void aDriveFaultEndsTheRunAndTheNextGoesOn_data();
    void aDriveFaultEndsTheRunAndTheNextGoesOn();
    void theHandHasNoSay_data() { addPlaces(); }
    void theHandHasNoSay();
};

// The print is 800 ppm longer than the program's bags, and the film slips.
void TestBothPlaces::cutsOnTheMarks()
{
    QFETCH(bool, drivesFilm);
    Line line(drivesFilm);
    line.start();
    QVERIFY(line.engages());
    (void)line.cutBags(10);
    const std::uint32_t followed = line.core().packer.marks.followed;
    const double largest = line.cutBags(300);
    QVERIFY2(largest < 0.2, qPrintable(QString::number(largest)));
    QCOMPARE(line.scrap, 0);
    QVERIFY(line.core().packer.marks.followed >= followed + 299);
    QVERIFY(line.core().packer.last_cut.tracked);
    QVERIFY(std::abs(line.controller().cut()->markErrorMm) < 0.5);
}

void TestBothPlaces::productsAreNotCut()
{
    QFETCH(bool, drivesFilm);
    MachineOptions options = onLine(drivesFilm);
    options.products.misplaced = 0.1;
    Line line(drivesFilm, options);
    QCOMPARE(line.status(CTL_REG_PARAMETER_ANTI_CUT), 1);
    line.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 10);
    line.start();
    QVERIFY(line.engages());
    const int cuts = cutsIn(line, 400'000'000);
    QVERIFY2(cuts > 300, qPrintable(QString::number(cuts)));
    QVERIFY2(line.core().packer.skipped > 10, qPrintable(QString::number(line.core().packer.skipped)));
    QCOMPARE(line.core().packer.last_skip, CTL_SKIP_CAUSE_PRODUCT_ACROSS);
    QCOMPARE(line.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
}

// Film that somebody else drives cannot wait: its bags are cut, and counted as empty.
void TestBothPlaces::missingProductsSaveOwnFilmAlone()
{
    QFETCH(bool, drivesFilm);
    MachineOptions options = onLine(drivesFilm);
    options.products.missing = 0.2;
    Line line(drivesFilm, options);
    line.setParameter(CTL_REG_PARAMETER_EMPTY_BAG, 1);
    line.start();
    QVERIFY(line.engages());
    (void)line.cutBags(10);
    const ctl_packer& packer = line.core().packer;
    const std::uint32_t empty = packer.empty;
    const int cuts = cutsIn(line, 200'000'000); // 200 cycles of the line
    const auto saved = static_cast<int>(packer.saved_um / 250'000);
    const auto newEmpty = static_cast<int>(packer.empty - empty);
    if (drivesFilm) {
        QCOMPARE(saved, 0);
        QVERIFY2(std::abs(cuts - 200) <= 2, qPrintable(QString::number(cuts)));
        QVERIFY2(newEmpty > 20 && newEmpty < 60, qPrintable(QString::number(newEmpty)));
    } else {
        QVERIFY2(saved > 20 && saved < 60, qPrintable(QString::number(saved)));
        QVERIFY2(std::abs(cuts + saved - 200) <= 5, qPrintable(QString::number(cuts)));
        QVERIFY2(newEmpty <= 2, qPrintable(QString::number(newEmpty)));
    }
    QCOMPARE(line.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
}

void TestBothPlaces::aDriveFaultEndsTheRunAndTheNextGoesOn_data()
{
    QTest::addColumn<bool>("drivesFilm");
    QTest::addColumn<bool>("isAlarm");
    QTest::newRow("shaft, alarm of the drive") << false << true;
    QTest::newRow("shaft, following error") << false << false;
    QTest::newRow("wheel, alarm of the drive") << true << true;
    QTest::newRow("wheel, following error") << true << false;
}

void TestBothPlaces::aDriveFaultEndsTheRunAndTheNextGoesOn()
{
    QFETCH(bool, drivesFilm);
    QFETCH(bool, isAlarm);
    Line line(drivesFilm);
    line.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 20); // products lie anywhere behind the fault
    line.start();
    QVERIFY(line.engages());
    (void)line.cutBags(12);
    const std::uint32_t limit = line.statusWide(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT);
    if (isAlarm)
        line.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
    else
        QCOMPARE(
            line.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {0, CTL_MIN_PARAMETER_FOLLOWING_ERROR_LIMIT}),
            0);
    QVERIFY(line.runUntilState(CTL_STATE_FAULT, 2'000'000));
    QCOMPARE(line.status(CTL_REG_STATUS_FAULT),
             1u << (isAlarm ? CTL_FAULT_BIT_DRIVE_ALARM : CTL_FAULT_BIT_FOLLOWING_ERROR));
    const std::int64_t commanded = line.core().motion.commanded;
    line.run(1'000'000); // the line goes on
    QVERIFY(!line.mayRun());
    QCOMPARE(line.core().motion.commanded, commanded);
    QCOMPARE(line.status(CTL_REG_MASTER_STATUS_STATE), CTL_MASTER_STATE_OFF);
    line.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, false);
    line.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT,
               {static_cast<std::uint16_t>(limit >> 16), static_cast<std::uint16_t>(limit & 0xFFFF)});
    line.run(100'000);
    QCOMPARE(line.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(line.engages());
    (void)line.cutBags(12);
    const double largest = line.cutBags(20);
    QVERIFY2(largest < 0.2, qPrintable(QString::number(largest)));
    QCOMPARE(line.scrap, 0);
    QVERIFY(line.mayRun());
}

// A run follows its encoder whatever hand.speed says; the next one by the clock is as slow as that.
void TestBothPlaces::theHandHasNoSay()
{
    QFETCH(bool, drivesFilm);
    Line line(drivesFilm);
    QCOMPARE(line.write(CTL_REG_HAND_SPEED, {20}), 0);
    line.start();
    QVERIFY(line.engages());
    (void)line.cutBags(12);
    QVERIFY(std::abs(cutsIn(line, 30'000'000) - 30) <= 1);
    QCOMPARE(line.write(CTL_REG_HAND_SPEED, {60}), 0); // nor in the run
    QVERIFY(std::abs(cutsIn(line, 30'000'000) - 30) <= 1);
    QVERIFY(std::abs(line.status(CTL_REG_STATUS_MASTER_SPEED) - 10'000) < 100);
    line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(line.runUntilState(CTL_STATE_READY));
    if (drivesFilm)
        return; // this film does not run by the clock
    line.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_CLOCK});
    line.run(10'000);
    line.start();
    line.run(5'000'000);
    QVERIFY(std::abs(line.status(CTL_REG_STATUS_MASTER_SPEED) - 6000) <= 2);
}

CAMPANEL_TEST(TestBothPlaces)

} // namespace test_both_places

#include "test_both_places.moc"
