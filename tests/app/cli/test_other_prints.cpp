// SPDX-License-Identifier: Apache-2.0
// Prints on the film that are no marks, and products that hang together. The row without the parameter stands
// beside the one with it and must fail.
#include "packing_bench.h"

#include "ctl_registers.h"

#include <QTest>

namespace test_other_prints {

using namespace campanel;
using namespace campanel::test;
using controller::PackedBag;
using controller::PackingEnd;
using controller::PackingJob;

namespace {

constexpr std::uint32_t bags = 3000;
constexpr double farMm = 0.4; // from its print, a customer sees it

struct Bags {
    std::ptrdiff_t settled = 0;
    std::ptrdiff_t far = 0;
    double largestMm = 0.0;
};

Bags countOf(const Packed& packed)
{
    Bags count;
    for (const PackedBag& bag : packed.bags) {
        if (!bag.isSettled)
            continue;
        ++count.settled;
        count.far += std::abs(bag.markErrorMm) > farMm ? 1 : 0;
        count.largestMm = std::max(count.largestMm, std::abs(bag.markErrorMm));
    }
    return count;
}

void addWidths(PackingJob& job, std::uint16_t minUm, std::uint16_t maxUm)
{
    set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MIN, minUm);
    set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MAX, maxUm);
}

} // namespace

class TestOtherPrints : public QObject {
    Q_OBJECT

private slots:
    // Between the marks lies another print at a fixed place: no two marks follow each other.
    void printBehindEachMark_data()
    {
        QTest::addColumn<double>("atMm");
        QTest::addColumn<double>("maskedMm");
        QTest::newRow("near the mark") << 20.0 << 150.0;
        QTest::newRow("near the next mark") << 225.0 << 240.0;
    }
    void printBehindEachMark()
    {
        QFETCH(double, atMm);
        QFETCH(double, maskedMm);
        const auto image = cutterAt(250, 60);
        const auto print = [atMm](PackingJob& job) { job.machine.film.printAtMm = atMm; };
        const Packed lost = pack(image, bags, print);
        QCOMPARE(lost.result.end, PackingEnd::Alarm);
        QCOMPARE(countOf(lost).settled, 0);
        const Packed found = pack(image, bags, [&](PackingJob& job) {
            print(job);
            set16(job, CTL_REG_PARAMETER_MARK_MASKING, static_cast<std::uint16_t>(10 * maskedMm));
        });
        QCOMPARE(found.result.end, PackingEnd::Done);
        QVERIFY(countOf(found).settled > bags - 10);
        QVERIFY(countOf(found).largestMm < farMm);
        QCOMPARE(found.result.marksFalse, 0u);
    }

    // The same print is told from a mark by its width, with a sensor that answers late, too.
    void printOfAnotherWidth_data()
    {
        QTest::addColumn<double>("widthMm");
        QTest::addColumn<double>("delayMs");
        QTest::newRow("narrow") << 2.0 << 0.0;
        QTest::newRow("wide") << 9.0 << 0.0;
        QTest::newRow("narrow, late sensor") << 2.0 << 2.0;
        QTest::newRow("wide, late sensor") << 9.0 << 2.0;
    }
    void printOfAnotherWidth()
    {
        QFETCH(double, widthMm);
        QFETCH(double, delayMs);
        const Packed packed = pack(cutterAt(250, 120), bags, [&](PackingJob& job) {
            job.machine.film.printAtMm = 20;
            job.machine.film.printWidthMm = widthMm;
            job.machine.sensors.delayMs = delayMs;
            job.machine.sensors.offLaterMs = delayMs; // the width of a mark would be 1 mm more
            const auto us = static_cast<std::uint16_t>(1000 * delayMs);
            set16(job, CTL_REG_PARAMETER_MARK_DEAD_TIME, us);
            set16(job, CTL_REG_PARAMETER_MARK_END_LATER, us);
            set16(job, CTL_REG_PARAMETER_EYE_DEAD_TIME, us);
            set16(job, CTL_REG_PARAMETER_EYE_END_DEAD_TIME, static_cast<std::uint16_t>(2 * us));
            addWidths(job, 4700, 5300);
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(countOf(packed).settled > bags - 10);
        QVERIFY(countOf(packed).largestMm < farMm);
        QVERIFY(packed.result.marksFalse > bags - 10);
        QCOMPARE(packed.result.marksMissing, 0u);
    }

    // Prints anywhere, within the window, too, and across a mark.
    void printsAnywhere_data()
    {
        QTest::addColumn<double>("widthMm");
        QTest::newRow("narrow") << 1.0;
        QTest::newRow("wide") << 12.0;
    }
    void printsAnywhere()
    {
        QFETCH(double, widthMm);
        const auto image = cutterAt(250, 60);
        const auto prints = [widthMm](PackingJob& job) {
            job.machine.film.marksFalse = 0.5;
            job.machine.film.falseWidthMm = widthMm;
            job.goOn = true;
        };
        QVERIFY(countOf(pack(image, bags, prints)).far > 0);
        const Packed packed = pack(image, bags, [&prints](PackingJob& job) {
            prints(job);
            addWidths(job, 4700, 5300);
        });
        QCOMPARE(packed.result.starts, 1u);
        QVERIFY(countOf(packed).settled > bags - 10);
        QCOMPARE(countOf(packed).far, 0);
        QVERIFY(packed.result.marksMissing > 0); // those that another print covers
    }

    // Two short products that hang together fit into a bag. Told by their length they end the run, and their
    // bag counts as empty, whether they were taken away or not.
    void joinedProducts()
    {
        const auto image = cutterAt(250, 60);
        const auto products = [](PackingJob& job) {
            job.machine.products.lengthMm = 60;
            job.machine.products.joined = 0.02;
            job.goOn = true;
        };
        const auto untold = [](const Packed& packed) {
            return std::ranges::count_if(packed.bags, [](const PackedBag& bag) {
                return bag.products > 1 && (bag.flags & 1u << CTL_BAG_BIT_EMPTY) == 0;
            });
        };
        QVERIFY(untold(pack(image, bags, products)) > 10);
        const Packed packed = pack(image, bags, [&products](PackingJob& job) {
            products(job);
            set16(job, CTL_REG_PARAMETER_PRODUCT_LENGTH_MAX, 700);
        });
        QCOMPARE(untold(packed), 0);
        QVERIFY(packed.result.alarms[CTL_WARNING_BIT_PRODUCTS_JOINED] > 10);
        QCOMPARE(packed.result.starts, packed.result.alarms[CTL_WARNING_BIT_PRODUCTS_JOINED] + 1);
        QVERIFY(!packed.anyThroughProduct());
    }
};

CAMPANEL_TEST(TestOtherPrints)

} // namespace test_other_prints

#include "test_other_prints.moc"
