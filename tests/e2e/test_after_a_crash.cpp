// SPDX-License-Identifier: Apache-2.0
// The panel's process is killed during a run: the machine continues, and the next panel displays it, on the
// same page. After a proper end it begins with the first page.
#include "app/panel/controller/controller.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace test_after_a_crash {

using namespace campanel;
using panel::Controller;

namespace {

constexpr int timeoutMs = 30'000;

class PanelProcess {
public:
    explicit PanelProcess(const QStringList& arguments)
    {
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(QCoreApplication::applicationFilePath(),
                        QStringList{QStringLiteral("panel_to_be_killed")} + arguments);
    }
    ~PanelProcess()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    // Returns the last output.
    QByteArray said()
    {
        while (m_process.canReadLine())
            m_said = m_process.readLine().trimmed();
        return m_said;
    }
    void kill() { end(SIGKILL); }
    void endInOrder() { end(SIGTERM); }
    [[nodiscard]] bool hasEndedItself() const
    {
        return m_process.exitStatus() == QProcess::NormalExit && m_process.exitCode() == 0;
    }

private:
    void end(int signal)
    {
        ::kill(static_cast<pid_t>(m_process.processId()), signal);
        m_process.waitForFinished(timeoutMs);
    }
    QProcess m_process;
    QByteArray m_said;
};

QByteArray shown(const QByteArray& page, Controller::State state)
{
    return "page " + page + " state " + QByteArray::number(static_cast<int>(state));
}

int campanelctl(const QStringList& arguments)
{
    return QProcess::execute(campanel::test::programPath("campanelctl"), arguments);
}

} // namespace

class TestAfterACrash : public QObject {
    Q_OBJECT

private slots:
    void theMachineRunsOnAndThePageComesBack()
    {
        const test::ControllerProcess controller;
        const QTemporaryDir folder;
        QCOMPARE(campanelctl({"download", "--port", controller.port()}), 0);
        QCOMPARE(campanelctl({"start", "--port", controller.port()}), 0);
        const QStringList panel{folder.path(), controller.port()};
        {
            PanelProcess first(panel + QStringList{"nav_recipes"});
            QTRY_COMPARE_WITH_TIMEOUT(first.said(), shown("recipes", Controller::State::Running), timeoutMs);
            first.kill();
            QVERIFY(!first.hasEndedItself());
        }
        {
            PanelProcess second(panel);
            QTRY_COMPARE_WITH_TIMEOUT(second.said(), shown("recipes", Controller::State::Running), timeoutMs);
            second.kill(); // again, without any touch
        }
        {
            PanelProcess third(panel);
            QTRY_COMPARE_WITH_TIMEOUT(third.said(), shown("recipes", Controller::State::Running), timeoutMs);
            third.endInOrder();
            QVERIFY(third.hasEndedItself());
        }
        PanelProcess last(panel);
        QTRY_COMPARE_WITH_TIMEOUT(last.said(), shown("run", Controller::State::Running), timeoutMs);
    }

    void anOutputUnderAFingerGoesOff()
    {
        const test::ControllerProcess controller({"--speed", "0.1"}); // its half second is five
        const QTemporaryDir folder;
        const auto isOn = [&controller] {
            QProcess status;
            status.start(campanel::test::programPath("campanelctl"),
                         {"status", "--format", "json", "--port", controller.port()});
            return status.waitForFinished(timeoutMs) &&
                   status.readAllStandardOutput().contains("\"Switch3\"");
        };
        PanelProcess panel({folder.path(), controller.port(), "nav_maintenance", "maintenanceMachine",
                            "maintenanceIo", "hold:try2"});
        QTRY_COMPARE_WITH_TIMEOUT(panel.said(), shown("maintenance", Controller::State::Idle) + " try 2",
                                  timeoutMs);
        QTest::qWait(500); // longer than a request
        panel.kill();
        QVERIFY(isOn());
        QTRY_VERIFY_WITH_TIMEOUT(!isOn(), timeoutMs);
    }

    void aDamagedMemoryOfThePageIsNoPage_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a word") << QByteArray("Trends\n");
        QTest::newRow("no such page") << QByteArray("jog\n");
        QTest::newRow("a number") << QByteArray("-1\n");
    }
    void aDamagedMemoryOfThePageIsNoPage()
    {
        QFETCH(QByteArray, text);
        const test::ControllerProcess controller;
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("open-page")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        PanelProcess panel({folder.path(), controller.port()});
        QTRY_COMPARE_WITH_TIMEOUT(panel.said(), shown("run", Controller::State::Idle), timeoutMs);
    }
};

CAMPANEL_TEST(TestAfterACrash)

} // namespace test_after_a_crash

#include "test_after_a_crash.moc"
