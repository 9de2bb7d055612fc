// SPDX-License-Identifier: Apache-2.0
// A process killed at random moments while it writes: no confirmed data is lost, the database opens and is
// valid, and the audit chain verifies.
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/stop_log.h"
#include "app/store/recipes/recipe_file.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QMap>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace test_killed {

using namespace campanel;

class TestKilled : public QObject {
    Q_OBJECT

    static constexpr int kills = 200;
    static constexpr int longestMs = 200;

    QTemporaryDir m_folder;
    QMap<QByteArray, qint64> m_confirmed; // the last number of each kind
    qint64 m_confirmations = 0;

    // Runs the writer for some time and kills it like a power switch.
    void runAndKill(int lifeMs)
    {
        QProcess writer;
        writer.start(QCoreApplication::applicationFilePath(),
                     {QStringLiteral("confirming_writer"), m_folder.path()});
        QVERIFY(writer.waitForStarted());
        QVERIFY(writer.waitForReadyRead(20'000));
        (void)writer.waitForFinished(lifeMs); // it does not end: time passes
        QCOMPARE(writer.state(), QProcess::Running);
        ::kill(static_cast<pid_t>(writer.processId()), SIGKILL);
        QVERIFY(writer.waitForFinished(20'000));
        const QByteArrayList lines = writer.readAllStandardOutput().split('\n');
        for (const QByteArray& line : lines) {
            const qsizetype space = line.indexOf(' ');
            if (space < 0 || line == lines.last()) // the last one may be incomplete
                continue;
            m_confirmed[line.left(space)] = line.mid(space + 1).toLongLong();
            ++m_confirmations;
        }
    }

    void check()
    {
        auto opened = store::Database::open(m_folder.path());
        QVERIFY2(opened, opened ? "" : qPrintable(store::StoreErrorText::describe(opened.error())));
        store::Database& database = **opened;
        QVERIFY2(database.opening().damagedKeptAs.isEmpty(), qPrintable(database.opening().damagedKeptAs));

        const auto newest = store::RecipeLibrary(database).newest();
        QVERIFY(newest && newest->size() == 1);
        QVERIFY2(newest->first().version >= m_confirmed["recipe"],
                 qPrintable(QStringLiteral("version %1").arg(newest->first().version)));
        const auto versions = store::RecipeLibrary(database).versions(newest->first().recipeId);
        QVERIFY(versions);
        QCOMPARE(versions->size(), newest->first().version); // none is missing in between

        const auto chain = store::verifyChain(database);
        QVERIFY(chain);
        QCOMPARE(chain->fault(), store::ChainCheck::Fault::None);
        QCOMPARE(chain->losses(), 0);
        QVERIFY(chain->rows() >= m_confirmed["audit"]);

        // The writer can be killed between its first confirmation, a recipe, and these.
        if (m_confirmed.contains("alarm")) {
            const auto alarms = store::alarmTable().page(database, 0, 1);
            QVERIFY(alarms && alarms->size() == 1);
            QVERIFY(alarms->first().id >= m_confirmed["alarm"]);
        }
        if (m_confirmed.contains("interval")) {
            const auto stops = store::StopLog::begin(database);
            QVERIFY(stops && stops->last && stops->stop); // the interval and its reason
            QVERIFY(stops->last->id >= m_confirmed["interval"]);
        }
        if (m_confirmed.contains("file")) {
            const auto file =
                store::readRecipe(QDir(m_folder.path()).filePath(QStringLiteral("working_copy.json")));
            QVERIFY(file);
            QVERIFY(file->version >= m_confirmed["file"]);
        }
    }

private slots:
    void nothingConfirmedIsLost()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int i = 0; i < kills; ++i) {
            const int lifeMs = random.bounded(longestMs);
            runAndKill(lifeMs);
            if (!QTest::currentTestFailed())
                check();
            if (QTest::currentTestFailed()) {
                qWarning("kill %d of seed %u, after %d ms", i, seed, lifeMs);
                return;
            }
        }
        qInfo("%d kills, %lld confirmations, none lost", kills, static_cast<long long>(m_confirmations));
    }
};

CAMPANEL_TEST(TestKilled)

} // namespace test_killed

#include "test_killed.moc"
