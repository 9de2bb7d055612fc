// SPDX-License-Identifier: Apache-2.0
// Bags of a machine that follows an encoder of the line's shaft: as good as with the clock, whatever the line
// does, and led so that the commands do not lag.
#include "packing_bench.h"

#include "ctl_registers.h"

#include <QTest>

namespace test_line_encoder {

using namespace campanel::test;
using campanel::controller::PackedBag;
using campanel::controller::PackingEnd;
using campanel::controller::PackingJob;

namespace {

void follow(PackingJob& job, double lengthMm, double rate, std::uint32_t counts)
{
    job.machine.shaft.counts = counts;
    job.machine.shaft.speedMmPerS = lengthMm * rate / 60.0;
    set16(job, CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    set32(job, CTL_REG_MASTER_COUNTS, counts);
}

double farthestMm(const std::vector<PackedBag>& bags)
{
    double farthest = 0.0;
    for (const PackedBag& bag : bags) {
        if (bag.isSettled)
            farthest = std::max(farthest, std::abs(bag.deviationMm));
    }
    return farthest;
}

} // namespace

class TestLineEncoder : public QObject {
    Q_OBJECT

private slots:
    void bagsHaveTheirLength_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("rate");
        QTest::addColumn<unsigned>("counts");
        QTest::addColumn<double>("rippleHz");
        for (const double lengthMm : {100.0, 249.0}) {
            for (const double rate : {60.0, fastestRate(lengthMm)}) {
                for (const unsigned counts : {10'000u, 2500u}) {
                    for (const double hz : {3.0, 11.0})
                        QTest::addRow("%g mm, %g/min, %u counts, %g Hz", lengthMm, rate, counts, hz)
                            << lengthMm << rate << counts << hz;
                }
            }
        }
    }
    void bagsHaveTheirLength()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, rate);
        QFETCH(unsigned, counts);
        QFETCH(double, rippleHz);
        const Packed packed = pack(cutterAt(lengthMm, rate), 200, [&](PackingJob& job) {
            follow(job, lengthMm, rate, counts);
            job.machine.shaft.ripple = 0.01;
            job.machine.shaft.rippleHz = rippleHz;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY2(farthestMm(packed.bags) < 0.2, qPrintable(QString::number(farthestMm(packed.bags))));
        QVERIFY(packed.result.startUpBags <= 4);
    }

    // A count is read anywhere behind its edge, on average half of it: the lag without the lead is that of a
    // slice.
    void theLeadTakesTheLagAway()
    {
        const auto lagMm = [](std::uint16_t lead) {
            return pack(cutterAt(250, 150), 50,
                        [lead](PackingJob& job) {
                            follow(job, 250, 150, 10'000);
                            set16(job, CTL_REG_MASTER_LEAD, lead);
                        })
                .result.lag.commands.meanMm;
        };
        QVERIFY2(std::abs(lagMm(1) - 0.0125) < 0.005, qPrintable(QString::number(lagMm(1))));
        QVERIFY2(std::abs(lagMm(0) - 0.0125 - 625.0 * 0.00025) < 0.005,
                 qPrintable(QString::number(lagMm(0))));
    }

    void onlyBagsAroundAStandstillAreOff()
    {
        const Packed packed = pack(cutterAt(250, 150), 600, [](PackingJob& job) {
            follow(job, 250, 150, 10'000);
            job.machine.shaft.ripple = 0.01;
            job.shaftStopEvery = 20;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(packed.result.shaftStops > 25);
        QVERIFY(packed.result.startUpBags <= 4 + 3 * packed.result.shaftStops);
        QVERIFY2(farthestMm(packed.bags) < 0.2, qPrintable(QString::number(farthestMm(packed.bags))));
    }

    // The knife alone follows; the flights of their infeed are where the products lie, but for the misplaced.
    void aWheelOnTheFilmIsAsGood_data()
    {
        QTest::addColumn<double>("lengthMm");
        QTest::addColumn<double>("misplaced");
        QTest::newRow("100 mm") << 100.0 << 0.0;
        QTest::newRow("353 mm, whose marks before the start look like one too many") << 353.0 << 0.0;
        QTest::newRow("250 mm, misplaced and missing products") << 250.0 << 0.02;
    }
    void aWheelOnTheFilmIsAsGood()
    {
        QFETCH(double, lengthMm);
        QFETCH(double, misplaced);
        const Packed packed =
            pack(cutterAt(lengthMm, 60), misplaced == 0.0 ? 200 : 1000, [&](PackingJob& job) {
                follow(job, lengthMm, 60, 10'000);
                job.machine.shaft.ripple = 0.01;
                job.machine.shaft.drivesFilm = true;
                job.machine.products.misplaced = misplaced;
                job.machine.products.missing = misplaced;
                set16(job, CTL_REG_MASTER_PLACE, CTL_MASTER_PLACE_WHEEL);
                set16(job, CTL_REG_MASTER_DELAY, 3979); // of the knife's servo: 1 / (pi x 80 Hz)
            });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY2(farthestMm(packed.bags) < 0.2, qPrintable(QString::number(farthestMm(packed.bags))));
        QVERIFY(std::ranges::none_of(packed.bags, &PackedBag::throughProduct));
    }

    void aLineThatIsTooFastEndsTheRun()
    {
        const Packed packed = pack(cutterAt(250, 60), 500, [](PackingJob& job) {
            follow(job, 250, 60, 10'000);
            job.machine.shaft.wave = 0.2;
        });
        QCOMPARE(packed.result.end, PackingEnd::Alarm);
        QCOMPARE(packed.result.detail, 1u << CTL_WARNING_BIT_MASTER_TOO_FAST);
    }
};

CAMPANEL_TEST(TestLineEncoder)

} // namespace test_line_encoder

#include "test_line_encoder.moc"
