// SPDX-License-Identifier: Apache-2.0
// Something under the jaws of the simulated packing machine: seen in time by a drive that reports in time,
// never where there is none, and nothing is cut that lay there.
#include "packing_bench.h"

#include "ctl_registers.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_jams {

using namespace campanel::test;
using campanel::controller::PackingEnd;
using campanel::controller::PackingJob;
using campanel::controller::PackingResult;

namespace {

PackingResult packed(double rate, std::uint32_t bags, const Change& change)
{
    return pack(cutterAt(250, rate), bags,
                [&change](PackingJob& job) {
                    job.goOn = true;
                    job.machine.jaws.sealNm = 0.5;
                    set16(job, CTL_REG_PARAMETER_JAM_DETECTION, 1);
                    set16(job, CTL_REG_PARAMETER_JAM_STOP_TIME, 20);
                    change(job);
                })
        .result;
}

} // namespace

class TestJams : public QObject {
    Q_OBJECT

private slots:
    // Within five degrees or four milliseconds of the first touch, whichever is later.
    void areSeenInTime_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("stiffness");
        for (const double rate : {60.0, 120.0, 300.0}) {
            for (const double stiffness : {20.0, 100.0})
                QTest::addRow("%g/min, %g N/mm", rate, stiffness) << rate << stiffness;
        }
    }
    void areSeenInTime()
    {
        QFETCH(double, rate);
        QFETCH(double, stiffness);
        const PackingResult result = packed(rate, 400, [stiffness](PackingJob& job) {
            job.machine.jaws.jams = 0.05;
            job.machine.jaws.stiffnessNPerMm = stiffness;
        });
        QCOMPARE(result.end, PackingEnd::Done);
        QVERIFY(result.jams.seen >= 15);
        QCOMPARE(result.jams.count, result.jams.seen + result.jams.notArmed);
        QCOMPARE(result.jams.falsely, 0u);
        QCOMPARE(result.jams.cutThrough, 0u);
        QVERIFY2(
            result.jams.longestSeenDegrees <= 5.0 || result.jams.longestSeenMs <= 4.0,
            qPrintable(
                QString("%1 deg, %2 ms").arg(result.jams.longestSeenDegrees).arg(result.jams.longestSeenMs)));
    }

    // A drive that reports every 10 ms sees none of them; its torque-limit input does, later.
    void aSlowDriveNeedsItsInput()
    {
        const PackingResult result = packed(60, 200, [](PackingJob& job) {
            job.machine.jaws.jams = 0.05;
            job.machine.report.everyMs = 10;
        });
        QCOMPARE(result.end, PackingEnd::Done);
        QCOMPARE(result.jams.seen, 0u);
        QVERIFY(result.jams.count >= 8);
        QCOMPARE(result.jams.cutThrough, 0u);
    }

    void noneIsSeenWhereThereIsNone_data()
    {
        QTest::addColumn<double>("everyMs");
        QTest::addColumn<double>("stops");
        QTest::addColumn<double>("misplaced");
        QTest::addColumn<int>("changeEvery");
        QTest::newRow("at once") << 0.0 << 0.0 << 0.0 << 0;
        QTest::newRow("late, stops") << 1.0 << 0.05 << 0.0 << 0;
        QTest::newRow("late, skipped cuts") << 1.0 << 0.0 << 0.05 << 0;
        QTest::newRow("late, changes of rate") << 1.0 << 0.0 << 0.0 << 100;
    }
    void noneIsSeenWhereThereIsNone()
    {
        QFETCH(double, everyMs);
        QFETCH(double, stops);
        QFETCH(double, misplaced);
        QFETCH(int, changeEvery);
        const auto half = cutterAt(250, 150);
        const int bags = std::max(4000, qEnvironmentVariableIntValue("CAMPANEL_BAGS"));
        const PackingResult result = packed(300, static_cast<std::uint32_t>(bags), [&](PackingJob& job) {
            job.machine.drive.frictionDrift = 0.3;
            job.machine.report = {everyMs, 1.0, 1.0};
            job.machine.products.misplaced = misplaced;
            job.stopShare = stops;
            job.otherBank = half.registers;
            job.changeEvery = static_cast<std::uint32_t>(changeEvery);
        });
        QCOMPARE(result.end, PackingEnd::Done);
        QCOMPARE(result.jams.falsely, 0u);
    }
};

CAMPANEL_TEST(TestJams)

} // namespace test_jams

#include "test_jams.moc"
