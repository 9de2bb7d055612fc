// SPDX-License-Identifier: Apache-2.0
// Minimum, maximum and clamped value: numbers as those of the standard library, and the end of a program of a
// test build that compares NaN.
#include "tests/support/test_program.h"

#include "profile/model/bounds.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTest>

#include <cmath>

namespace test_bounds {

using namespace campanel::profile;
using namespace Qt::StringLiterals;

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

// Compares NaN in the way that its argument names.
int compareNan(int argc, char** argv)
{
    const QByteArray way(argc > 1 ? argv[argc - 1] : "");
    double largest = 1;
    double timeS = 0;
    Extent extent;
    if (way == "first")
        return maxOf(nan, 1) > 0;
    if (way == "second")
        return minOf(1, nan) > 0;
    if (way == "third of four")
        return maxOf(1, 2, nan, 3) > 0;
    if (way == "clamped")
        return clamped(nan, 0, 1) > 0;
    if (way == "bound")
        return clamped(0.5, 0, nan) > 0;
    if (way == "candidate")
        return raise(largest, timeS, nan, 1);
    if (way == "extent")
        extent.add(nan);
    return 0;
}

} // namespace

class TestBounds : public QObject {
    Q_OBJECT

private slots:
    void numbers()
    {
        QCOMPARE(maxOf(1.5, -2), 1.5);
        QCOMPARE(minOf(1.5, -2), -2.0);
        QCOMPARE(maxOf(1, 7, 3, 2.5), 7.0);
        QCOMPARE(minOf(4.0, 7.0, 3.0), 3.0);
        QCOMPARE(maxOf(std::size_t{3}, std::size_t{4}), std::size_t{4});
        QCOMPARE(clamped(-1, 0.0, 1.0), 0.0);
        QCOMPARE(clamped(0.5, 0, 1), 0.5);
        QCOMPARE(clamped(HUGE_VAL, 0, 1), 1.0);
        QCOMPARE(clamped(12, 3, 5), 5);
        double largest = 1;
        double timeS = 0;
        QVERIFY(!raise(largest, timeS, -1, 1));
        QVERIFY(raise(largest, timeS, -2, 3));
        QCOMPARE(largest, 2.0);
        QCOMPARE(timeS, 3.0);
        QVERIFY(!raise(largest, timeS, 2.1, 4, 0.1));
        Extent extent;
        extent.add(-3);
        extent.add(5);
        QCOMPARE(extent.span(), 8.0);
        QCOMPARE(wholeOf(-2.5), -3);
        QCOMPARE(wholeOf(1e30), 1000000000);
        QCOMPARE(wholeOf(nan), -1000000000);
    }

    void nanEndsATestBuild_data()
    {
        QTest::addColumn<bool>("ends");
        for (const char* way :
             {"first", "second", "third of four", "clamped", "bound", "candidate", "extent"})
            QTest::newRow(way) << true;
        QTest::newRow("none") << false;
    }

    void nanEndsATestBuild()
    {
        QFETCH(bool, ends);
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(),
                      {u"compare-nan"_s, QString::fromUtf8(QTest::currentDataTag())});
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitStatus(), ends ? QProcess::CrashExit : QProcess::NormalExit);
        QCOMPARE(program.readAllStandardError().contains("NaN"), ends);
    }
};

CAMPANEL_TEST(TestBounds)
CAMPANEL_PROCESS("compare-nan", compareNan)

} // namespace test_bounds

#include "test_bounds.moc"
