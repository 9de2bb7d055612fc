// SPDX-License-Identifier: Apache-2.0
// A panel killed at random moments during a stop: the stop goes on with its reason, at most a minute of its
// time is missing after each kill, and no second is there twice.
#include "app/store/logs/stop_log.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace test_stops_killed {

using namespace campanel;
using store::StateInterval;

namespace {

constexpr qint64 stopStartMs = 1'768'478'400'000;
constexpr qint64 writePeriodMs = 61'000; // a minute and the step of the clock

} // namespace

class TestStopsKilled : public QObject {
    Q_OBJECT

    static constexpr int kills = 40;
    static constexpr int longestMs = 120;

    QTemporaryDir m_folder;

    // Returns a time that is in a confirmed write: at least the begin.
    qint64 runAndKill(qint64 wallMs, int lifeMs)
    {
        QProcess panel;
        panel.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("stopping_panel"), m_folder.path(), QStringLiteral("100"),
                     QString::number(wallMs)});
        if (!panel.waitForStarted() || !panel.waitForReadyRead(20'000))
            return -1;
        (void)panel.waitForFinished(lifeMs); // it does not end: time passes
        ::kill(static_cast<pid_t>(panel.processId()), SIGKILL);
        panel.waitForFinished(20'000);
        const QByteArrayList lines = panel.readAllStandardOutput().split('\n');
        // The last line may be incomplete, and the first is no number.
        return lines.size() < 2 ? 0 : lines[lines.size() - 2].toLongLong();
    }

private slots:
    // A killed panel does not remove its temporary folder.
    void initTestCase() { qputenv("TMPDIR", m_folder.path().toLocal8Bit()); }

    void nothingIsLostAndNothingCountsTwice()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        qint64 wallMs = stopStartMs;
        qint64 confirmedMs = 0;
        for (int i = 0; i < kills; ++i) {
            const qint64 beginMs = wallMs;
            const qint64 lastMs = runAndKill(beginMs, random.bounded(longestMs));
            QVERIFY2(lastMs >= 0, qPrintable(QStringLiteral("kill %1 of seed %2").arg(i).arg(seed)));
            confirmedMs += std::max<qint64>(0, lastMs - beginMs);
            const auto database = store::Database::open(m_folder.path());
            QVERIFY(database);
            const auto span = store::StopLog::between(**database, 0, 2 * stopStartMs);
            QVERIFY(span && !span->intervals.isEmpty());
            qint64 sumMs = 0;
            qint64 endMs = 0;
            for (const StateInterval& each : span->intervals) {
                QVERIFY2(each.beginMs >= endMs, qPrintable(QString::number(seed)));
                QCOMPARE(each.stop, span->intervals.first().id);
                endMs = each.endMs();
                sumMs += each.durationMs;
            }
            QVERIFY2(endMs >= lastMs, qPrintable(QStringLiteral("%1 of %2").arg(endMs).arg(lastMs)));
            QVERIFY2(sumMs >= confirmedMs,
                     qPrintable(QStringLiteral("%1 of %2").arg(sumMs).arg(confirmedMs)));
            QCOMPARE(span->stops.size(), 1);
            QCOMPARE(span->stops.first().reason, QStringLiteral("cleaning"));
            confirmedMs = sumMs;
            wallMs = std::max(endMs, beginMs) + writePeriodMs; // the panel starts again
        }
        qInfo("%d kills of seed %u, %lld min of one stop", kills, seed,
              static_cast<long long>(confirmedMs / 60'000));
    }
};

CAMPANEL_TEST(TestStopsKilled)

} // namespace test_stops_killed

#include "test_stops_killed.moc"
