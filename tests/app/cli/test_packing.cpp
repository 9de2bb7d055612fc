// SPDX-License-Identifier: Apache-2.0
// The bags of the simulated packing machine: accuracy over the lengths of the paper's Table 2, steps of the
// film's stretch, misplaced products, and the influence of seed and time step.
#include "packing_bench.h"

#include "ctl_registers.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_packing {

using namespace campanel;
using namespace campanel::test;
using controller::PackedBag;
using controller::PackingEnd;
using controller::PackingJob;

namespace {

constexpr double toleranceMm = 0.2;
constexpr double lostPhaseMm = 2.0;

bool isTracked(const PackedBag& bag)
{
    return (bag.flags >> CTL_BAG_BIT_TRACKED & 1u) != 0;
}

} // namespace

class TestPacking : public QObject {
    Q_OBJECT

private slots:
    void accuracy_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("rate");
        for (const double lengthMm : paperLengthsMm) {
            QTest::addRow("%g mm at 60", lengthMm) << lengthMm << 60.0;
            QTest::addRow("%g mm at its largest rate", lengthMm) << lengthMm << fastestRate(lengthMm);
        }
    }
    void accuracy()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, rate);
        QVERIFY(rate <= 300);
        const Packed packed = pack(cutterAt(lengthMm, rate), 300);
        QCOMPARE(packed.result.end, PackingEnd::Done);
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (const PackedBag& bag : packed.bags) {
            if (!bag.isSettled)
                continue;
            ++count;
            sum += bag.deviationMm;
            squares += bag.deviationMm * bag.deviationMm;
            QVERIFY2(std::abs(bag.deviationMm) <= toleranceMm,
                     qPrintable(QStringLiteral("bag %1: %2 mm").arg(bag.number).arg(bag.deviationMm)));
        }
        QVERIFY(count >= 295);
        const double mean = sum / count;
        QVERIFY2(std::abs(mean) <= 0.05, qPrintable(QString::number(mean)));
        QVERIFY(std::sqrt(squares / count - mean * mean) <= 0.06);
    }

    // Compares with the same film without tracking, which deviates by its stretch.
    void withoutTracking()
    {
        const Packed packed = pack(cutterAt(250, 60), 300,
                                   [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_TRACKING, 0); });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(packed.bags.back().deviationMm < -toleranceMm);
        QVERIFY(packed.bags.back().markErrorMm < -lostPhaseMm);
    }

    void stepOfStretch_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("step");
        for (const double lengthMm : {100.0, 250.0, 460.0}) {
            QTest::addRow("%g mm longer", lengthMm) << lengthMm << 0.01;
            QTest::addRow("%g mm shorter", lengthMm) << lengthMm << -0.01;
        }
    }
    void stepOfStretch()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, step);
        constexpr std::uint32_t arrival = 100;
        const Packed packed = pack(cutterAt(lengthMm, 60), 300, [&](PackingJob& job) {
            job.machine.film.stretchStep = step;
            job.machine.film.stretchStepM = arrival * lengthMm / 1000;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        int outside = 0;
        for (const PackedBag& bag : packed.bags) {
            if (!bag.isSettled || std::abs(bag.deviationMm) <= toleranceMm)
                continue;
            ++outside;
            QVERIFY2(bag.number + 2 >= arrival && bag.number <= arrival + 12,
                     qPrintable(QString::number(bag.number)));
        }
        QVERIFY2(outside <= 5, qPrintable(QString::number(outside)));
        QVERIFY(std::ranges::all_of(packed.bags, [](const PackedBag& bag) {
            return !isTracked(bag) || std::abs(bag.markErrorMm) <= lostPhaseMm;
        }));
    }

    // Only the step: one or two bags in each direction, then constant lengths.
    void noOscillation_data() { stepOfStretch_data(); }
    void noOscillation()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, step);
        constexpr std::uint32_t arrival = 100;
        const Packed packed = pack(cutterAt(lengthMm, 60), 200, [&](PackingJob& job) {
            job.machine.film.slipMm = 0;
            job.machine.film.stretch = 0;
            job.machine.film.markNoiseMm = 0;
            job.machine.film.stretchStep = step;
            job.machine.film.stretchStepM = arrival * lengthMm / 1000;
        });
        constexpr double noticedMm = 0.05;
        constexpr double restMm = 0.02; // a pulse of the film motor is 0.015 mm
        int crossings = 0;
        int side = 0;
        double largest = 0;
        for (const PackedBag& bag : packed.bags) {
            if (bag.number < arrival - 10)
                continue;
            largest = std::max(largest, std::abs(bag.deviationMm));
            QVERIFY(bag.number < arrival + 12 || std::abs(bag.deviationMm) <= restMm);
            if (std::abs(bag.deviationMm) < noticedMm)
                continue;
            const int now = bag.deviationMm > 0 ? 1 : -1;
            crossings += side != 0 && now != side ? 1 : 0;
            side = now;
        }
        QVERIFY(largest > 0); // it had an effect
        QVERIFY2(crossings <= 2, qPrintable(QString::number(crossings)));
    }

    // False marks, some of them just before the true one: the nearer one is used.
    void falseMarks_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("step");
        for (const double lengthMm : {100.0, 250.0, 460.0}) {
            QTest::addRow("%g mm", lengthMm) << lengthMm << 0.0;
            QTest::addRow("%g mm and a step of stretch", lengthMm) << lengthMm << 0.01;
        }
    }
    void falseMarks()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, step);
        const Packed packed = pack(cutterAt(lengthMm, 60), 3000, [&](PackingJob& job) {
            job.machine.film.marksFalse = 0.2;
            set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MAX, 5300); // one that touches the mark makes it wider
            job.machine.film.stretchStep = step;
            job.machine.film.stretchStepM = lengthMm; // in a thousand bags
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(packed.result.marksFalse > 500);
        const auto outside = std::ranges::count_if(packed.bags, [](const PackedBag& bag) {
            return bag.isSettled && std::abs(bag.deviationMm) > toleranceMm;
        });
        QVERIFY2(outside <= (step == 0.0 ? 0 : 5), qPrintable(QString::number(outside)));
        QVERIFY(std::ranges::none_of(packed.bags, [](const PackedBag& bag) {
            return isTracked(bag) && std::abs(bag.markErrorMm) > lostPhaseMm;
        }));
    }

    void misplacedProducts()
    {
        const Packed packed = pack(cutterAt(250, 60), 20'000, [](PackingJob& job) {
            job.machine.products.misplaced = 0.05;
            job.machine.products.missing = 0.05;
            job.goOn = true;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(!packed.anyThroughProduct());
        QVERIFY(packed.result.cutsSkipped > 300);
        QCOMPARE(packed.result.skipsUnexplained, 0u);
        // The clearance, and the errors of the eye and the product's slip on the film.
        QVERIFY2(packed.result.maxSkipGapMm < 5 + 2, qPrintable(QString::number(packed.result.maxSkipGapMm)));
        QCOMPARE(packed.result.skips[CTL_SKIP_CAUSE_PRODUCT_ACROSS], packed.result.cutsSkipped);
        std::uint32_t skipped = 0;
        for (const PackedBag& bag : packed.bags) {
            skipped += bag.lengths - 1;
            QVERIFY((bag.lengths > 1) == (bag.skipCause != CTL_SKIP_CAUSE_NONE));
            QVERIFY(!bag.isSettled || !isTracked(bag) || std::abs(bag.markErrorMm) <= lostPhaseMm);
        }
        QCOMPARE(skipped, packed.result.cutsSkipped);
        QCOMPARE(packed.result.emptyBags, packed.emptyBags());
    }

    // No product, no bag: the same film makes no empty bags.
    void filmIsSaved()
    {
        const auto run = [](std::uint16_t save) {
            return pack(cutterAt(250, 60), 1000, [save](PackingJob& job) {
                job.machine.products.missing = 0.1;
                set16(job, CTL_REG_PARAMETER_EMPTY_BAG, save);
            });
        };
        const Packed wasted = run(0);
        const Packed saved = run(1);
        const auto empties = [](const Packed& packed) {
            return std::ranges::count_if(
                packed.bags, [](const PackedBag& bag) { return bag.isSettled && bag.products == 0; });
        };
        for (const Packed* packed : {&wasted, &saved})
            QCOMPARE(packed->result.emptyBags, packed->emptyBags());
        QVERIFY(empties(wasted) > 50);
        QVERIFY2(empties(saved) <= 1, qPrintable(QString::number(empties(saved))));
        QCOMPARE(wasted.result.filmSavedM, 0.0);
        QVERIFY(saved.result.filmSavedM > 12);
        QVERIFY(!saved.anyThroughProduct());
    }

    // The time steps of fast runs: no bag differs by much more than a pulse of the film motor, and the
    // standard deviation by a micrometer.
    void stepsOfTime_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("rate");
        QTest::newRow("100 mm, slow") << 100.0 << 60.0;
        QTest::newRow("100 mm, fast") << 100.0 << fastestRate(100);
        QTest::newRow("250 mm, slow") << 250.0 << 60.0;
        QTest::newRow("460 mm, fast") << 460.0 << fastestRate(460);
    }
    void stepsOfTime()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, rate);
        const program::ProgramImage image = cutterAt(lengthMm, rate);
        const Packed quick = pack(image, 200);
        const Packed usual = pack(image, 200, [](PackingJob& job) { job.stepUs = 250; });
        QCOMPARE(quick.bags.size(), usual.bags.size());
        double largest = 0;
        double squares[2] = {};
        for (std::size_t i = 20; i < quick.bags.size(); ++i) {
            largest = std::max(largest, std::abs(quick.bags[i].lengthMm - usual.bags[i].lengthMm));
            squares[0] += std::pow(quick.bags[i].deviationMm, 2);
            squares[1] += std::pow(usual.bags[i].deviationMm, 2);
        }
        QVERIFY2(largest <= 0.02, qPrintable(QString::number(largest)));
        const double count = static_cast<double>(quick.bags.size() - 20);
        QVERIFY(std::abs(std::sqrt(squares[0] / count) - std::sqrt(squares[1] / count)) <= 0.001);
    }

    void sameSeedSameBags()
    {
        const program::ProgramImage image = cutterAt(250, 60);
        const auto lengths = [&image](std::uint64_t seed) {
            std::vector<double> list;
            for (const PackedBag& bag :
                 pack(image, 100, [seed](PackingJob& job) { job.machine.seed = seed; }).bags)
                list.push_back(bag.lengthMm);
            return list;
        };
        QVERIFY(lengths(1) == lengths(1));
        QVERIFY(lengths(1) != lengths(2));
    }
};

CAMPANEL_TEST(TestPacking)

} // namespace test_packing

#include "test_packing.moc"
