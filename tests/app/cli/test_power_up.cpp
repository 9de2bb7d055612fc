// SPDX-License-Identifier: Apache-2.0
// After a power cut nobody knows where film and knife are: axes may have been turned and film pulled by hand.
// No bag is off and unmarked; with thread up no product is cut either.
#include "packing_bench.h"

#include "ctl_registers.h"

#include <QTest>

namespace test_power_up {

using namespace campanel::test;
using campanel::controller::PackingEnd;
using campanel::controller::PackingJob;

class TestPowerUp : public QObject {
    Q_OBJECT

private slots:
    void nothingIsOffAndUnmarked_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<bool>("threadsUp");
        for (const double rate : {60.0, 200.0}) {
            QTest::addRow("%g/min", rate) << rate << false;
            QTest::addRow("%g/min, thread up", rate) << rate << true;
        }
    }
    void nothingIsOffAndUnmarked()
    {
        QFETCH(double, rate);
        QFETCH(bool, threadsUp);
        const Packed packed = pack(cutterAt(250, rate), 4000, [threadsUp](PackingJob& job) {
            job.powerCutShare = 0.05;
            job.goOn = true;
            if (threadsUp)
                set16(job, CTL_REG_PARAMETER_THREAD_UP, 1);
        });
        const auto& result = packed.result;
        QCOMPARE(result.end, PackingEnd::Done);
        QVERIFY(result.powerCuts > 150);
        QCOMPARE(result.offUnmarked, 0u);
        const auto through =
            std::ranges::count_if(packed.bags, &campanel::controller::PackedBag::throughProduct);
        const double scrap = static_cast<double>(result.startUpBags) / result.starts;
        if (threadsUp) {
            QCOMPARE(through, 0);
            QVERIFY2(scrap <= 1.0, qPrintable(QString::number(scrap)));
        } else {
            QVERIFY(through > 100);
            QVERIFY(scrap > 3.0);
        }
        QVERIFY2(result.meanFilmToGoodMm < 2000, qPrintable(QString::number(result.meanFilmToGoodMm)));
    }

    // Without mark tracking there is nothing to wait for: the knife does not stay open.
    void threadsUpByMarksOnly()
    {
        const Packed packed = pack(cutterAt(250, 60), 20, [](PackingJob& job) {
            set16(job, CTL_REG_PARAMETER_THREAD_UP, 1);
            set16(job, CTL_REG_PARAMETER_MARK_TRACKING, 0);
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
    }
};

CAMPANEL_TEST(TestPowerUp)

} // namespace test_power_up

#include "test_power_up.moc"
