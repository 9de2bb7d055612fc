// SPDX-License-Identifier: Apache-2.0
// A panel killed at random moments during downloads to a running machine. The machine continues with one
// whole program, the confirmed one or a later one, and no confirmed data is lost.
#include "tests/support/controller_process.h"

#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/recipe/controller_program.h"
#include "app/panel/settings/settings.h"
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace test_killed_downloads {

using namespace campanel;
using test::ControllerProcess;

namespace {

constexpr int kills = 40;
constexpr int longestMs = 900;
constexpr int timeoutMs = 20'000;

} // namespace

class TestKilledDownloads : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    ControllerProcess m_controller;
    qint64 m_version = 0;
    qint64 m_sequence = 0;
    qint64 m_generation = 0;
    QString m_crc;       // confirmed
    QStringList m_begun; // started after that
    int m_confirmed = 0;

    void take(const QByteArray& line)
    {
        const QStringList words = QString::fromLatin1(line).split(u' ');
        if (words[0] == u"recipe") {
            m_version = words[1].toLongLong();
        } else if (words[0] == u"audit") {
            m_sequence = words[1].toLongLong();
        } else if (words[0] == u"begun") {
            m_begun << words[1];
        } else if (words[0] == u"program") {
            m_generation = words[1].toLongLong();
            m_crc = words[2];
            m_begun = m_begun.mid(m_begun.lastIndexOf(m_crc) + 1);
            ++m_confirmed;
        }
    }

    void runAndKill(int lifeMs)
    {
        QProcess panel;
        panel.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        panel.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("downloading_panel"), m_folder.path(), m_controller.port()});
        QVERIFY(panel.waitForReadyRead(timeoutMs)); // it is at work
        (void)panel.waitForFinished(lifeMs);
        QCOMPARE(panel.state(), QProcess::Running);
        ::kill(static_cast<pid_t>(panel.processId()), SIGKILL);
        QVERIFY(panel.waitForFinished(timeoutMs));
        QByteArrayList lines = panel.readAllStandardOutput().split('\n');
        lines.removeLast(); // may be incomplete
        for (const QByteArray& line : lines)
            take(line);
    }

    void checkController(bool mustRun)
    {
        link::ThreadedLink link(nullptr);
        const QTemporaryDir folder;
        panel::Settings settings(folder.filePath(QStringLiteral("settings.ini")), nullptr);
        panel::Controller machine(link, settings, nullptr);
        link::ConnectionSettings wanted;
        wanted.simulated = false;
        wanted.port = m_controller.port();
        link.connectTo(wanted);
        QTRY_VERIFY_WITH_TIMEOUT(machine.isConnected() && machine.status(), timeoutMs);
        if (m_crc.isEmpty())
            return;
        QTRY_VERIFY_WITH_TIMEOUT(machine.active().isPresent, timeoutMs);
        const auto status = *machine.status();
        QVERIFY(status.activeCrc.has_value());
        const QString crc = QString::number(*status.activeCrc, 16).toUpper().rightJustified(8, u'0');
        QVERIFY2(crc == m_crc || m_begun.contains(crc),
                 qPrintable(crc + u' ' + m_crc + u' ' + m_begun.join(u' ')));
        QVERIFY(qint64(status.generation) >= m_generation);
        if (mustRun)
            QCOMPARE(machine.state(), panel::Controller::State::Running);
        // Until the next confirmation that one is possible too.
        m_begun << crc;
    }

    void checkDatabase()
    {
        auto opened = store::Database::open(m_folder.path());
        QVERIFY2(opened, opened ? "" : qPrintable(store::StoreErrorText::describe(opened.error())));
        store::Database& database = **opened;
        const auto newest = store::RecipeLibrary(database).newest();
        QVERIFY(newest);
        QVERIFY(m_version == 0 || (newest->size() == 1 && newest->first().version >= m_version));
        const auto chain = store::verifyChain(database);
        QVERIFY(chain);
        QCOMPARE(chain->fault(), store::ChainCheck::Fault::None);
        QCOMPARE(chain->losses(), 0);
        QVERIFY(chain->rows() >= m_sequence);
    }

private slots:
    void theMachineRunsOnAndNothingConfirmedIsLost()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int i = 0; i < kills; ++i) {
            // The first ones run until the machine runs.
            const bool isFirst = m_confirmed == 0;
            const int lifeMs = isFirst ? 3000 : random.bounded(longestMs);
            runAndKill(lifeMs);
            if (!QTest::currentTestFailed())
                checkController(!isFirst);
            if (!QTest::currentTestFailed())
                checkDatabase();
            if (QTest::currentTestFailed()) {
                qWarning("kill %d of seed %u, after %d ms", i, seed, lifeMs);
                return;
            }
        }
        qInfo("%d kills, %d downloads confirmed, version %lld, %lld audit rows", kills, m_confirmed,
              static_cast<long long>(m_version), static_cast<long long>(m_sequence));
        QVERIFY(m_confirmed > 0);
    }
};

CAMPANEL_TEST(TestKilledDownloads)

} // namespace test_killed_downloads

#include "test_killed_downloads.moc"
