// SPDX-License-Identifier: Apache-2.0
// The line breaks and recovers: controller killed and restarted, port lost and back under another name, an
// interrupted download, a jogging panel killed. The panel's own classes on one side, campanel-controller on
// its pseudo-terminal on the other. Prints its measurements.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/settings/settings.h"
#include "modbus/map/codec.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

namespace test_line_trouble {

using namespace campanel;
using panel::Controller;
using panel::Editor;
using panel::ProgramDownload;
using test::ControllerProcess;

namespace {

constexpr int timeoutMs = 20'000;
constexpr qint64 reconnectLimitMs = 2000;
constexpr qint64 jogLimitMs = 350; // the controller's 200 ms, its ramp, and the polling

struct Panel {
    Panel()
        : machine(link, settings, nullptr)
        , editor(machine, test::withStoredRecipe(folder.path()), nullptr)
    {
    }

    void openPort(const QString& port)
    {
        panel::ConnectionChoice choice;
        choice.simulated = false;
        choice.portName = port;
        settings.overrideConnection(choice);
        machine.open();
    }

    void openSimulated(std::uint32_t baud)
    {
        link::ConnectionSettings wanted;
        wanted.simulatorProgram = campanel::test::programPath("campanel-controller");
        wanted.simulatorStateDir = folder.filePath(QStringLiteral("state"));
        wanted.line.baud = baud;
        link.connectTo(wanted);
    }

    [[nodiscard]] bool isConnected() const { return machine.isConnected() && machine.fresh(); }

    void download()
    {
        QTRY_VERIFY2_WITH_TIMEOUT(editor.programDownload()->canDownload(),
                                  qPrintable(editor.programDownload()->text()), timeoutMs);
        editor.download();
        QTRY_COMPARE_WITH_TIMEOUT(editor.programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(machine.active().isPresent, timeoutMs);
    }

    QTemporaryDir folder;
    link::ThreadedLink link{nullptr};
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    Controller machine;
    Editor editor;
};

// Checks that the panel displays the last status, and that the status is current.
void verifyTrue(const Panel& panel)
{
    const auto& status = *panel.machine.status();
    QVERIFY(panel.machine.fresh());
    QCOMPARE(panel.machine.generation(), static_cast<double>(status.generation));
    QCOMPARE(panel.machine.live().cycleCount, static_cast<double>(status.cycleCount));
    QCOMPARE(panel.machine.active().isPresent, status.activeCrc.has_value());
}

modbus::LinkSettings lineTo(const char* port)
{
    modbus::LinkSettings settings;
    settings.port = port;
    return settings;
}

// Holds the jog key on the port of its argument, until it is killed.
int jog(int argc, char** argv)
{
    if (argc != 2)
        return 1;
    modbus::RtuClient client(lineTo(argv[1]));
    if (!client.open() || !client.identify())
        return 1;
    bool isTold = false;
    for (std::uint16_t heartbeat = 1;; ++heartbeat) {
        const auto status = client.exchangeStatus(heartbeat, 1);
        if (!status)
            return 1;
        if (!isTold && status->state == modbus::State::Jogging && status->axisPositionPulses > 100) {
            isTold = true;
            std::puts("jogging");
            std::fflush(stdout);
        }
    }
}

} // namespace

class TestLineTrouble : public QObject {
    Q_OBJECT

private slots:
    void controllerIsKilledAndStartedAgain();
    void stopPressedWithoutALineIsSentWhenItIsBack();
    void portComesBackUnderAnotherName();
    void controllerRestartsWhileItRuns();
    void tornDownloadGoesOn();
    void jogDiesWithItsPanel();
};

void TestLineTrouble::controllerIsKilledAndStartedAgain()
{
    ControllerProcess controller;
    Panel panel;
    panel.openPort(controller.port());
    panel.download();
    panel.editor.saveToFlash();
    QTRY_VERIFY_WITH_TIMEOUT(panel.editor.programDownload()->isSaved(), timeoutMs);
    panel.machine.start();
    QTRY_VERIFY_WITH_TIMEOUT(panel.machine.bags().count >= 1, timeoutMs);

    controller.kill();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.connection(), Controller::Connection::Lost, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(!panel.machine.fresh(), timeoutMs);
    QVERIFY(panel.machine.bags().count >= 1); // the last one, grey
    QVERIFY2(panel.machine.connectionText().contains(controller.port()),
             qPrintable(panel.machine.connectionText()));
    panel.machine.start(); // never sent
    QCOMPARE(panel.machine.commandMessage(), QStringLiteral("There is no connection to the controller."));

    controller.start();
    QElapsedTimer sinceReturn;
    sinceReturn.start();
    QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
    const qint64 tookMs = sinceReturn.elapsed();
    qInfo("restart of the controller: connected %lld ms after its port was back", tookMs);
    QVERIFY(tookMs < reconnectLimitMs);
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
    QCOMPARE(panel.machine.bags().count, 0.0);
    QCOMPARE(panel.machine.commandMessage(),
             QStringLiteral("Connection restored. The controller has restarted meanwhile."));
    verifyTrue(panel);
}

void TestLineTrouble::stopPressedWithoutALineIsSentWhenItIsBack()
{
    Panel panel;
    panel.openSimulated(115200);
    panel.download();
    panel.machine.start();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Running, timeoutMs);
    panel.link.simulateFaults({QStringLiteral("unplug when=answer time=1500 limit=1")});
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.connection(), Controller::Connection::Lost, timeoutMs);
    panel.machine.stop();
    QTRY_VERIFY_WITH_TIMEOUT(panel.machine.stopWaits(), timeoutMs);
    QTRY_COMPARE_WITH_TIMEOUT(
        panel.machine.commandMessage(),
        QStringLiteral("Connection restored: Stop was sent, and the controller accepted the command."),
        timeoutMs);
    QVERIFY(!panel.machine.stopWaits());
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
}

void TestLineTrouble::portComesBackUnderAnotherName()
{
    Panel panel;
    panel.openSimulated(115200);
    panel.download();
    const QString before = panel.machine.portName();
    panel.link.simulateFaults({QStringLiteral("unplug when=answer time=800 limit=1")});
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.connection(), Controller::Connection::Lost, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(!QFileInfo::exists(before), timeoutMs);
    // A terminal opened now gets the smallest free number: the old one, or one that another program freed.
    const auto number = [](const QString& name) { return name.section(u'/', -1).toInt(); };
    std::vector<int> taken;
    do {
        taken.push_back(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
        QVERIFY(taken.back() >= 0);
    } while (number(QFile::decodeName(::ptsname(taken.back()))) < number(before));
    QElapsedTimer sinceReturn;
    QString after;
    const auto connection =
        QObject::connect(&panel.machine, &Controller::connectionChanged, &panel.machine, [&] {
            if (!sinceReturn.isValid() && panel.machine.portName() != before) {
                after = panel.machine.portName();
                sinceReturn.start(); // the port exists and has just been tried
            }
        });
    QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && sinceReturn.isValid(), timeoutMs);
    const qint64 tookMs = sinceReturn.elapsed();
    QObject::disconnect(connection);
    std::ranges::for_each(taken, &::close);
    qInfo("port back under another name (%s, was %s): connected and fresh %lld ms after", qPrintable(after),
          qPrintable(before), tookMs);
    QVERIFY(after != before);
    QVERIFY(tookMs < reconnectLimitMs);
    verifyTrue(panel);
}

void TestLineTrouble::controllerRestartsWhileItRuns()
{
    Panel panel;
    panel.openSimulated(115200);
    panel.download();
    panel.machine.start();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Running, timeoutMs);
    QSignalSpy lost(&panel.machine, &Controller::freshChanged);
    panel.link.simulateFaults({QStringLiteral("restart time=1600 limit=1")});
    QElapsedTimer sinceSilence;
    sinceSilence.start();
    QTRY_VERIFY_WITH_TIMEOUT(!panel.machine.fresh(), timeoutMs);
    QVERIFY(!panel.machine.canStart());
    QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
    const qint64 tookMs = sinceSilence.elapsed() - 1600;
    qInfo("controller restarted in a silence of 1600 ms: connected and fresh %lld ms after it", tookMs);
    QVERIFY(tookMs < reconnectLimitMs);
    // Nothing was saved: it has no program now, and the panel reports it.
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Idle, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(!panel.machine.active().isPresent, timeoutMs);
    verifyTrue(panel);
}

void TestLineTrouble::tornDownloadGoesOn()
{
    Panel panel;
    panel.openSimulated(9600);
    QTRY_VERIFY2_WITH_TIMEOUT(panel.editor.programDownload()->canDownload(),
                              qPrintable(panel.editor.programDownload()->text()), timeoutMs);
    double tornAt = -1;
    double resumedAt = -1;
    bool isTorn = false;
    QObject::connect(
        &panel.link, &link::Link::downloadReported, &panel.machine, [&](const link::DownloadReport& report) {
            if (report.isInterrupted && tornAt < 0)
                tornAt = report.fraction;
            if (tornAt >= 0 && !report.isInterrupted && resumedAt < 0)
                resumedAt = report.fraction;
            if (!isTorn && report.fraction > 0.3) {
                isTorn = true;
                panel.link.simulateFaults({QStringLiteral("unplug when=answer time=600 limit=1")});
            }
        });
    panel.editor.download();
    QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Applied,
                              timeoutMs);
    qInfo("download torn at %.0f %%, went on at %.0f %%", 100 * tornAt, 100 * resumedAt);
    QVERIFY(tornAt > 0.2);
    QVERIFY(resumedAt >= tornAt - 0.1);
    QTRY_VERIFY_WITH_TIMEOUT(panel.machine.active().isPresent, timeoutMs);
    QCOMPARE(panel.machine.active().name, panel.editor.recipeName());
    panel.editor.programDownload()->proof()->compare();
    QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->proof()->result(),
                              panel::ProgramProof::Result::Equal, timeoutMs);
}

void TestLineTrouble::jogDiesWithItsPanel()
{
    const ControllerProcess controller;
    QProcess panel;
    panel.start(QCoreApplication::applicationFilePath(), {QStringLiteral("jog"), controller.port()});
    QVERIFY(panel.waitForReadyRead(timeoutMs));
    QCOMPARE(panel.readLine().trimmed(), QByteArray("jogging"));
    QElapsedTimer sinceKill;
    sinceKill.start();
    panel.kill();
    QVERIFY(panel.waitForFinished(timeoutMs));

    // Only reads: writing a heartbeat would influence the test.
    modbus::RtuClient witness(lineTo(qPrintable(controller.port())));
    QVERIFY(witness.open());
    const modbus::RegisterInfo& state = modbus::registerNamed("status.state");
    const auto isJogging = [&] {
        const auto read = witness.readProven(state.address, 1);
        return read && read->front() == static_cast<std::uint16_t>(modbus::State::Jogging);
    };
    QVERIFY2(isJogging(), "it was no longer jogging when the witness first looked");
    const qint64 stillMs = sinceKill.elapsed();
    while (isJogging() && sinceKill.elapsed() < timeoutMs) {
    }
    const qint64 endedMs = sinceKill.elapsed();
    qInfo("jogging panel killed: still jogging after %lld ms, standing after %lld ms", stillMs, endedMs);
    QVERIFY(endedMs < jogLimitMs);
}

CAMPANEL_TEST(TestLineTrouble)
CAMPANEL_PROCESS("jog", jog)

} // namespace test_line_trouble

#include "test_line_trouble.moc"
