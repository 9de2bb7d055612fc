// SPDX-License-Identifier: Apache-2.0
// Sensors that answer late: where the cut lies on the print then, and while the rate changes.
#include "packing_bench.h"

#include "ctl_registers.h"

#include <QTest>

namespace test_late_sensors {

using namespace campanel;
using namespace campanel::test;
using controller::PackedBag;
using controller::PackingEnd;
using controller::PackingJob;

namespace {

constexpr double sPerMs = 1e-3;
constexpr double sPerMin = 60.0;
constexpr std::uint32_t bags = 1000;
constexpr std::uint32_t changeEvery = 50;

struct Spread {
    std::size_t count = 0;
    double mean = 0;
    double rms = 0;
    double largest = 0;
};

template <typename Value> Spread spreadOf(const Packed& packed, Value value)
{
    Spread spread;
    for (const PackedBag& bag : packed.bags) {
        if (!bag.isSettled)
            continue;
        const double one = value(bag);
        ++spread.count;
        spread.mean += one;
        spread.rms += one * one;
        spread.largest = std::max(spread.largest, std::abs(one));
    }
    spread.mean /= static_cast<double>(spread.count);
    spread.rms = std::sqrt(spread.rms / static_cast<double>(spread.count));
    return spread;
}

Spread markError(const Packed& packed)
{
    return spreadOf(packed, [](const PackedBag& bag) { return bag.markErrorMm; });
}

Spread deviation(const Packed& packed)
{
    return spreadOf(packed, [](const PackedBag& bag) { return bag.deviationMm; });
}

} // namespace

class TestLateSensors : public QObject {
    Q_OBJECT

private slots:
    // At constant speed the film has gone on by delay x speed when the output changes.
    void movesTheCutOnThePrint_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("delayMs");
        QTest::newRow("300 mm, 300/min, 1 ms") << 300.0 << 300.0 << 1.0;
        QTest::newRow("300 mm, 60/min, 2 ms") << 300.0 << 60.0 << 2.0;
        QTest::newRow("100 mm, 200/min, 0.5 ms") << 100.0 << 200.0 << 0.5;
    }
    void movesTheCutOnThePrint()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, rate);
        QFETCH(double, delayMs);
        const auto image = cutterAt(lengthMm, rate);
        const Packed prompt = pack(image, bags);
        const Packed late =
            pack(image, bags, [delayMs](PackingJob& job) { job.machine.sensors.delayMs = delayMs; });
        QCOMPARE(late.result.end, PackingEnd::Done);
        const double wayMm = lengthMm * rate / sPerMin * delayMs * sPerMs;
        const double moved = markError(late).mean - markError(prompt).mean;
        QVERIFY2(std::abs(moved - wayMm) < 0.02, qPrintable(QString::number(moved)));
        QVERIFY(std::abs(deviation(late).mean) < 0.01);
    }

    // Known dead times take the cut back to where prompt sensors put it, while the rate changes, too.
    void knownDeadTimes_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("delayMs");
        for (const double lengthMm : {100.0, 300.0, 460.0}) {
            for (const double delayMs : {0.5, 1.0, 2.0, 10.0})
                QTest::addRow("%g mm, %g ms", lengthMm, delayMs) << lengthMm << delayMs;
        }
    }
    void knownDeadTimes()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, delayMs);
        const double rate = fastestRate(lengthMm);
        const auto image = cutterAt(lengthMm, rate);
        const auto half = cutterAt(lengthMm, rate / 2);
        const auto changes = [&half](PackingJob& job) {
            job.otherBank = half.registers;
            job.changeEvery = changeEvery;
        };
        const auto late = [&](PackingJob& job) {
            changes(job);
            job.machine.sensors.delayMs = delayMs;
        };
        const Packed prompt = pack(image, bags, changes);
        const Packed unknown = pack(image, bags, late);
        const Packed known = pack(image, bags, [&](PackingJob& job) {
            late(job);
            const auto deadUs = static_cast<std::uint16_t>(delayMs / sPerMs);
            set16(job, CTL_REG_PARAMETER_MARK_DEAD_TIME, deadUs);
            set16(job, CTL_REG_PARAMETER_EYE_DEAD_TIME, deadUs);
            set16(job, CTL_REG_PARAMETER_EYE_END_DEAD_TIME, deadUs);
        });
        QCOMPARE(known.result.end, PackingEnd::Done);
        QVERIFY2(markError(known).rms <= markError(prompt).rms + 0.01,
                 qPrintable(QString::number(markError(known).rms)));
        QVERIFY2(markError(known).largest <= 0.4, qPrintable(QString::number(markError(known).largest)));
        QVERIFY2(deviation(known).largest <= 0.2, qPrintable(QString::number(deviation(known).largest)));
        QCOMPARE(known.result.marksMissing, prompt.result.marksMissing);
        QVERIFY(!known.anyThroughProduct());
        if (lengthMm * rate / sPerMin * delayMs * sPerMs > 0.3) // what is moved so far is seen
            QVERIFY(markError(unknown).rms > markError(prompt).rms + 0.05);
    }

    // An eye that is 10 ms late, 15 ms at the end of a product: products are cut until the controller knows
    // it.
    void noProductIsCut()
    {
        const auto image = cutterAt(300, 300);
        const auto late = [](PackingJob& job) {
            job.machine.sensors.delayMs = 10;
            job.machine.sensors.offLaterMs = 5;
            job.machine.products.misplaced = 0.05;
            job.machine.products.missing = 0.05;
            set16(job, CTL_REG_PARAMETER_MARK_DEAD_TIME, 10'000);
            job.goOn = true;
        };
        QVERIFY(pack(image, 5000, late).anyThroughProduct());
        const Packed known = pack(image, 5000, [&late](PackingJob& job) {
            late(job);
            set16(job, CTL_REG_PARAMETER_EYE_DEAD_TIME, 10'000);
            set16(job, CTL_REG_PARAMETER_EYE_END_DEAD_TIME, 15'000);
        });
        QVERIFY(!known.anyThroughProduct());
        QCOMPARE(known.result.skipsUnexplained, 0u);
    }

    // The eye must be farther away the later it answers.
    void lateEyeIsTooNear()
    {
        const auto image = cutterAt(300, 300);
        const auto nearEye = [](std::uint16_t deadUs) {
            return [deadUs](PackingJob& job) {
                job.machine.products.eyeMm = 760;
                set32(job, CTL_REG_PARAMETER_EYE_DISTANCE, 760'000);
                set16(job, CTL_REG_PARAMETER_EYE_DEAD_TIME, deadUs);
            };
        };
        QCOMPARE(pack(image, 10, nearEye(0)).result.end, PackingEnd::Done);
        const Packed late = pack(image, 10, nearEye(20'000));
        QCOMPARE(late.result.end, PackingEnd::Refused);
        QCOMPARE(late.result.detail, std::uint32_t{CTL_REFUSAL_EYE_TOO_NEAR});
    }

    // A rate is changed by a program that takes over while the machine runs: no bag is an exception.
    void changesTheRate_data()
    {
        QTest::addColumn<double>("lengthMm");
        for (const double lengthMm : {200.0, 300.0, 460.0})
            QTest::addRow("%g mm", lengthMm) << lengthMm;
    }
    void changesTheRate()
    {
        QFETCH(double, lengthMm);
        const double rate = fastestRate(lengthMm);
        const auto image = cutterAt(lengthMm, rate);
        const auto half = cutterAt(lengthMm, rate / 2);
        const Packed packed = pack(image, bags, [&half](PackingJob& job) {
            job.otherBank = half.registers;
            job.changeEvery = changeEvery;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        std::size_t fast = 0;
        std::size_t slow = 0;
        for (std::size_t i = 1; i < packed.bags.size(); ++i) {
            const double is = sPerMin / (packed.bags[i].timeS - packed.bags[i - 1].timeS);
            fast += std::abs(is / rate - 1.0) < 0.01 ? 1u : 0u;
            slow += std::abs(is / rate - 0.5) < 0.01 ? 1u : 0u;
        }
        QVERIFY2(fast > bags * 4 / 10 && slow > bags * 4 / 10,
                 qPrintable(QStringLiteral("%1 fast, %2 slow").arg(fast).arg(slow)));
        QVERIFY(deviation(packed).count + 5 > bags); // no bag of a change is left out
        QVERIFY2(deviation(packed).largest <= 0.2, qPrintable(QString::number(deviation(packed).largest)));
        QVERIFY2(markError(packed).largest <= 0.4, qPrintable(QString::number(markError(packed).largest)));
    }
};

CAMPANEL_TEST(TestLateSensors)

} // namespace test_late_sensors

#include "test_late_sensors.moc"
