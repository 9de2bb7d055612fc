// SPDX-License-Identifier: Apache-2.0
// The recorded trends of a running machine, and their window: it follows the time, is moved and zoomed, and
// has statistics. File errors are reported once.
#include "app/store/logs/bag_log.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QPointF>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <memory>

namespace test_trends {

using namespace campanel;
using panel::Trends;
using test::PanelRig;
using namespace std::chrono_literals;

namespace {

constexpr qint64 startMs = 1'800'000'000'000;

struct Rig : PanelRig {
    qint64 wallMs = startMs;

    Rig()
    {
        trends.setWallClock([this] { return wallMs; });
    }
    void show()
    {
        trends.open();
        trends.setWatched(true);
        waitForAnswer();
    }
    void waitForAnswer()
    {
        for (int round = 0; round < 2; ++round) {
            bool isAnswered = false;
            trends.store().run(
                &trends, [](store::Database&) { return true; }, [&](bool) { isAnswered = true; });
            QTRY_VERIFY(isAnswered);
        }
    }
    // Updates at the end of the second, so that its bags are in the window.
    void showPage()
    {
        wallMs += 1;
        trends.showNow();
        waitForAnswer();
    }
    // Sends a status in which the present bag is complete.
    void passBag(double deviationMm)
    {
        wallMs += 1000;
        ++link.status.bagCount;
        link.status.bagLengthMm = 250 + deviationMm;
        link.status.bagDeviationMm = deviationMm;
        link::StatusBatch batch;
        batch.samples << link::StatusSample{now, link.status, 8ms};
        emit link.statusReceived(batch);
    }
    QList<store::Bag> bags()
    {
        QList<store::Bag> found;
        trends.store().run(
            &trends,
            [](store::Database& database) {
                QList<store::Bag> all;
                (void)store::BagLog(database).forEach(0, 2 * startMs,
                                                      [&](const store::Bag& bag) { all << bag; });
                return all;
            },
            [&](const QList<store::Bag>& all) { found = all; });
        waitForAnswer();
        return found;
    }
    double statistic(int lane, const char* name)
    {
        return trends.statistics().value(lane).toMap().value(QString::fromLatin1(name), -1).toDouble();
    }
    QList<QPointF> means(int lane)
    {
        const auto curves = trends.curves().value<std::shared_ptr<const QList<QList<QPointF>>>>();
        return curves && curves->size() > 3 * lane ? curves->at(3 * lane) : QList<QPointF>();
    }
};

} // namespace

class TestTrends : public QObject {
    Q_OBJECT

private slots:
    void everyBagIsKeptWithWhatIsKnownOfIt()
    {
        Rig rig;
        rig.settings.set("bags.tolerance_mm", panel::settingText(0.2));
        rig.connectRunning();
        rig.show();
        QCOMPARE(rig.trends.content(), Trends::NothingYet);
        rig.link.status.followingErrorPulses = -40;
        rig.passBag(9); // begun under another program
        for (const double deviation : {0.1, -0.3, 0.05})
            rig.passBag(deviation);
        rig.showPage();
        QCOMPARE(rig.trends.content(), Trends::Shown);
        QCOMPARE(rig.statistic(0, "count"), 3.0); // deviation
        QVERIFY(std::abs(rig.statistic(0, "mean") + 0.05) < 1e-9);
        QCOMPARE(rig.statistic(0, "low"), -0.3);
        QCOMPARE(rig.statistic(0, "high"), 0.1);
        QVERIFY(std::abs(rig.statistic(0, "within") - 2.0 / 3) < 1e-9);
        QCOMPARE(rig.statistic(1, "count"), 0.0); // this controller reports no mark errors
        const QList<store::Bag> bags = rig.bags();
        QCOMPARE(bags.size(), 3);
        QCOMPARE(bags[0].timeMs, startMs + 2000);
        QCOMPARE(bags[0].programName, QStringLiteral("Biscuit 250"));
        QCOMPARE(bags[0].setLengthMm, 250.0);
        QCOMPARE(bags[1].deviationMm, -0.3);
        QCOMPARE(bags[1].rateBagsPerMin.value_or(0), 60.0);
        QVERIFY(bags[1].followingErrorMm.value_or(0) < 0);
    }

    void aResidueOfAThousandBagsIsAPoint()
    {
        Rig rig;
        rig.connectRunning();
        for (const int quantity : {Trends::JamResidue, Trends::Deviation, Trends::MarkError})
            rig.trends.toggle(quantity);
        QCOMPARE(rig.trends.chosen(), QList<int>{Trends::JamResidue});
        rig.show();
        rig.passBag(0);
        rig.trends.recordResidue(-0.15);
        rig.showPage();
        QCOMPARE(rig.statistic(0, "count"), 1.0);
        QCOMPARE(rig.statistic(0, "mean"), -0.15);
    }

    void rateLatencyAndFollowingErrorComeFromTheStatus()
    {
        Rig rig;
        rig.connectRunning();
        rig.link.status.followingErrorPulses = 40;
        for (const int quantity : {Trends::MarkError, Trends::Latency, Trends::FollowingError})
            rig.trends.toggle(quantity);
        QCOMPARE(rig.trends.chosen(),
                 QList<int>({Trends::Deviation, Trends::FollowingError, Trends::Latency}));
        rig.trends.toggle(Trends::BagLength); // replaces the lowest
        QCOMPARE(rig.trends.chosen(),
                 QList<int>({Trends::BagLength, Trends::Deviation, Trends::FollowingError}));
        for (const int quantity : {Trends::BagLength, Trends::Deviation, Trends::Rate, Trends::Latency})
            rig.trends.toggle(quantity);
        QCOMPARE(rig.trends.chosen(), QList<int>({Trends::FollowingError, Trends::Rate, Trends::Latency}));
        rig.show();
        rig.passBag(0);
        rig.showPage();
        QCOMPARE(rig.statistic(0, "high"), std::round(40 / rig.machine.program()->pulsesPerMm * 1000) / 1000);
        QCOMPARE(rig.statistic(1, "high"), 60.0);
        QCOMPARE(rig.statistic(2, "mean"), 8.0);
        // At standstill there is no following error, and the rate is zero.
        rig.link.status.state = modbus::State::Ready;
        const double before = rig.statistic(0, "count");
        rig.passBag(0);
        rig.showPage();
        QCOMPARE(rig.statistic(0, "count"), before);
        QCOMPARE(rig.statistic(1, "low"), 0.0);
    }

    void pausesAreGaps()
    {
        Rig rig;
        rig.connectRunning();
        rig.show();
        rig.passBag(0);
        for (int i = 0; i < 4; ++i)
            rig.passBag(0.1);
        rig.wallMs += 60'000;
        for (int i = 0; i < 4; ++i)
            rig.passBag(0.2);
        rig.showPage();
        const QList<QPointF> means = rig.means(0);
        int gaps = 0;
        for (const QPointF& point : means)
            gaps += std::isnan(point.y()) ? 1 : 0;
        QCOMPARE(gaps, 1);
        QVERIFY(means.size() >= 5);
        QVERIFY(std::ranges::is_sorted(means, {}, &QPointF::x));
    }

    void windowFollowsTheTimeUntilItIsMovedAway()
    {
        Rig rig;
        rig.show();
        QVERIFY(rig.trends.live());
        QCOMPARE(rig.trends.toMs(), double(startMs));
        rig.wallMs += 5000;
        QTRY_COMPARE(rig.trends.toMs(), double(rig.wallMs));
        rig.trends.showWindow(startMs - 900'000, startMs - 300'000);
        QVERIFY(!rig.trends.live());
        rig.wallMs += 5000;
        rig.trends.refresh();
        rig.waitForAnswer();
        QCOMPARE(rig.trends.toMs(), double(startMs - 300'000));
        rig.trends.showNow();
        QVERIFY(rig.trends.live());
        QCOMPARE(rig.trends.toMs(), double(rig.wallMs));
        QCOMPARE(rig.trends.spanMs(), 600'000.0);
    }

    void windowStaysBetweenItsLimits()
    {
        Rig rig;
        rig.trends.showWindow(startMs - 1000, startMs + 500'000);
        QVERIFY(rig.trends.live()); // not into the future
        QCOMPARE(rig.trends.toMs(), double(startMs));
        rig.trends.showSpan(1);
        QCOMPARE(rig.trends.spanMs(), double(Trends::shortestSpanMs));
        rig.trends.showSpan(1e15);
        QCOMPARE(rig.trends.spanMs(), double(Trends::longestSpanMs));
        rig.trends.showWindow(startMs - 7'200'000, startMs - 3'600'000);
        rig.trends.zoom(0.5); // around the middle
        QCOMPARE(rig.trends.fromMs(), startMs - 6'300'000.0);
        QCOMPARE(rig.trends.toMs(), startMs - 4'500'000.0);
    }

    void neverWithoutACurve()
    {
        Rig rig;
        rig.trends.toggle(Trends::MarkError);
        rig.trends.toggle(Trends::Deviation);
        QCOMPARE(rig.trends.chosen(), QList<int>{Trends::Deviation});
        rig.trends.toggle(99);
        QCOMPARE(rig.trends.chosen(), QList<int>{Trends::Deviation});
    }

    void whatWasRecordedIsThereAfterARestart()
    {
        QTemporaryDir folder;
        {
            Rig rig;
            Trends trends(rig.machine, rig.settings, rig.records, folder.path(), nullptr);
            trends.setWallClock([&] { return rig.wallMs; });
            trends.open();
            rig.connectRunning();
            rig.passBag(0);
            rig.passBag(0.1);
        } // without a write in between
        Rig rig;
        Trends trends(rig.machine, rig.settings, rig.records, folder.path(), nullptr);
        trends.setWallClock([&] { return startMs + 10'000; });
        trends.open();
        trends.setWatched(true);
        QTRY_COMPARE(trends.content(), Trends::Shown);
        QCOMPARE(trends.statistics().value(0).toMap().value(QStringLiteral("count")).toDouble(), 1.0);
    }

    void exportOffersBagsAndColumns()
    {
        Rig rig;
        rig.connectRunning();
        rig.show();
        rig.passBag(0);
        rig.passBag(0.125);
        rig.showPage();
        QSignalSpy ready(rig.trends.csv(), &panel::CsvExport::ready);
        rig.trends.csv()->make(rig.maintenance.files());
        QVERIFY(rig.trends.csv()->busy());
        QVERIFY(ready.wait());
        QVERIFY(!rig.trends.csv()->busy());
        const QString folder = rig.folder.filePath(QStringLiteral("out"));
        panel::ReportFiles& files = *rig.maintenance.files();
        QTRY_VERIFY(!files.busy());
        files.setScanner([&](const QString&) {
            QDir().mkpath(folder);
            return QList<store::Place>{{folder, QStringLiteral("out"), false}};
        });
        files.scan();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        QVERIFY2(files.message().endsWith(QStringLiteral("2 files in ") + folder),
                 qPrintable(files.message()));
        QFile bags(folder + QStringLiteral("/bags.csv"));
        QVERIFY(bags.open(QIODevice::ReadOnly));
        QVERIFY(bags.readAll().contains(",250.125,0.125,"));
        QFile trends(folder + QStringLiteral("/trends.csv"));
        QVERIFY(trends.open(QIODevice::ReadOnly));
        QVERIFY(trends.readAll().contains("deviation_mm,1,0.125,0.125,0.125"));
    }

    void whatCannotBeKeptIsToldOnce()
    {
        Rig rig;
        rig.connectRunning();
        rig.show();
        bool isFull = false;
        rig.trends.store().run(
            &rig.trends,
            [](store::Database& database) {
                auto pages = database.execute(QStringLiteral("PRAGMA page_count"));
                if (!pages || !pages->next())
                    return false;
                const QString limit =
                    QStringLiteral("PRAGMA max_page_count = %1").arg(pages->value(0).toInt());
                pages->finish();
                return database.execute(limit).has_value();
            },
            [&](bool done) { isFull = done; });
        rig.waitForAnswer();
        QVERIFY(isFull);
        QSignalSpy told(&rig.records, &panel::DatabaseService::noticeChanged);
        for (int round = 0; round < 40 && told.isEmpty(); ++round) {
            for (int i = 0; i < 100; ++i)
                rig.passBag(0.1);
            rig.showPage();
        }
        QVERIFY(rig.records.notice().contains(QStringLiteral("full")));
        for (int i = 0; i < 300; ++i)
            rig.passBag(0.1);
        rig.showPage();
        QCOMPARE(told.size(), 1);
    }

    void damagedFileIsToldAndAnotherOneBegun()
    {
        Rig rig;
        QFile file(rig.folder.filePath(QStringLiteral("trends.sqlite")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(9000, 'x')) == 9000);
        file.close();
        rig.connectRunning();
        rig.show();
        QTRY_VERIFY(rig.records.notice().contains(QStringLiteral("damaged")));
        rig.passBag(0);
        rig.passBag(0.1);
        rig.showPage();
        QCOMPARE(rig.statistic(0, "count"), 1.0);
    }
};

CAMPANEL_TEST(TestTrends)

} // namespace test_trends

#include "test_trends.moc"
