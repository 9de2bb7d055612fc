// SPDX-License-Identifier: Apache-2.0
// A Stop that is pressed without a connection, whose answer is lost with it, or while the controller works
// on another command.
#include "app/link/link_worker.h"
#include "link_panel.h"
#include "tests/support/controller_process.h"
#include "tests/support/scripted_slave.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

namespace test_held_stop {

using namespace campanel;
using link::CommandEnd;
using link::LinkState;
using modbus::Command;
using test::ControllerProcess;
using test::Fault;
using test::imageOf;
using test::Panel;
using test::portSettings;
using test::timeoutMs;
using Depth = modbus::ScanPlan::Depth;

// A link worker in this thread, so that the scripted faults meet the command that is requested next.
struct Scripted {
    Scripted()
    {
        QObject::connect(&worker, &link::LinkWorker::reported, &worker, [this](const link::LinkReport& said) {
            report = said;
            wasPending = wasPending || said.pendingStop == Command::StopNow;
        });
        QObject::connect(
            &worker, &link::LinkWorker::statusReceived, &worker,
            [this](const link::StatusBatch& batch) { statuses += static_cast<int>(batch.samples.size()); });
        QObject::connect(&worker, &link::LinkWorker::commandEnded, &worker,
                         [this](const link::CommandOutcome& outcome) { outcomes << outcome; });
        worker.connectTo(portSettings(QString::fromStdString(slave.port())));
    }
    [[nodiscard]] bool isConnected() const { return report.state == LinkState::Connected && statuses > 2; }

    test::ScriptedSlave slave;
    link::LinkReport report;
    int statuses = 0;
    bool wasPending = false;
    QList<link::CommandOutcome> outcomes;
    link::LinkWorker worker;
};

class TestHeldStop : public QObject {
    Q_OBJECT

private slots:
    void stopWaitsForTheLineAndIsSentOnce()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopAtCycleEnd, {}});
        panel.link.request({2, Command::StopNow, {}});
        panel.link.request({3, Command::StopAtCycleEnd, {}});
        panel.link.request({4, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 3, timeoutMs);
        QCOMPARE(panel.report.pendingStop, Command::StopNow);
        QCOMPARE(panel.outcomes[0].id, 1u); // replaced by the more urgent one
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Withdrawn);
        QCOMPARE(panel.outcomes[1].id, 3u); // less urgent than the waiting one
        QCOMPARE(panel.outcomes[1].end, CommandEnd::Withdrawn);
        QCOMPARE(panel.outcomes[2].id, 4u); // other commands do not wait
        QCOMPARE(panel.outcomes[2].end, CommandEnd::NotSent);
        controller.start();
        QElapsedTimer sinceReturn;
        sinceReturn.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 4, timeoutMs);
        QVERIFY2(sinceReturn.elapsed() < 2000, qPrintable(QString::number(sinceReturn.elapsed())));
        QCOMPARE(panel.outcomes[3].id, 2u);
        QCOMPARE(panel.outcomes[3].end, CommandEnd::Refused); // it reached a controller at standstill
        QCOMPARE(panel.outcomes[3].reason, modbus::Refusal::NotRunning);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.report.pendingStop, timeoutMs);
    }

    void withdrawnStopIsNotSent()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.pendingStop, Command::StopNow, timeoutMs);
        panel.link.withdrawStop();
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Withdrawn);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.report.pendingStop, timeoutMs);
        controller.start();
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && panel.statuses > 20, timeoutMs);
        QCOMPARE(panel.outcomes.size(), 1);
        QVERIFY(panel.status->commandCounter <= 1); // at most the clock was set
    }

    void stopForAnotherConnectionIsNotKept()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopNow, {}});
        panel.link.connectTo(portSettings(QStringLiteral("/dev/ttyThatIsNotThere")));
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::NotSent);
        // Never connected, so there is nothing to stop.
        panel.link.request({2, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 2, timeoutMs);
        QCOMPARE(panel.outcomes[1].end, CommandEnd::NotSent);
    }

    void stopIsSentAfterAScan()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.run(imageOf(250));
        panel.link.startScan(Depth::Diagnosis);
        panel.link.request({7, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].id, 7u);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Done);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(modbus::State::Ready), timeoutMs);
    }

    void doubtfulStopIsLookedUpAndCarriedOutOnce_data()
    {
        QTest::addColumn<int>("first");
        QTest::newRow("received, answer lost") << static_cast<int>(Fault::LostAnswer);
        QTest::newRow("not received") << static_cast<int>(Fault::LostRequest);
    }

    void doubtfulStopIsLookedUpAndCarriedOutOnce()
    {
        QFETCH(int, first);
        Scripted scripted;
        test::ScriptedSlave& slave = scripted.slave;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        // The Stop itself and the client's three questions after it.
        slave.script({static_cast<Fault>(first), Fault::LostRequest, Fault::LostRequest, Fault::LostRequest});
        scripted.worker.request({9, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 1, timeoutMs);
        QCOMPARE(scripted.outcomes[0].id, 9u);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::Done);
        QVERIFY(scripted.wasPending);
        QCOMPARE(slave.commandsExecuted(), 1);
        QVERIFY(!scripted.report.pendingStop);
    }

    void undeliveredStopIsSentAgain_data()
    {
        QTest::addColumn<QList<int>>("faults");
        const auto row = [](const char* name, std::initializer_list<Fault> faults) {
            QList<int> numbers;
            for (const Fault fault : faults)
                numbers << static_cast<int>(fault);
            QTest::newRow(name) << numbers;
        };
        row("lost once", {Fault::LostRequest});
        row("lost three times",
            {Fault::LostRequest, Fault::None, Fault::LostRequest, Fault::None, Fault::LostRequest});
        row("the controller is busy", {Fault::Busy});
        row("busy twice", {Fault::Busy, Fault::None, Fault::Busy});
    }

    // The controller says that it has not received the Stop: nothing is in doubt, so it is sent again.
    void undeliveredStopIsSentAgain()
    {
        QFETCH(QList<int>, faults);
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        std::vector<Fault> script;
        for (const int fault : faults)
            script.push_back(static_cast<Fault>(fault));
        scripted.slave.script(script);
        scripted.worker.request({9, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 1, timeoutMs);
        QCOMPARE(scripted.outcomes[0].id, 9u);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::Done);
        QCOMPARE(scripted.slave.commandsExecuted(), 1);
        QVERIFY(!scripted.report.pendingStop);
    }

    // Only a Stop is sent again: a person decides about another start.
    void undeliveredStartIsNot()
    {
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        scripted.slave.script({Fault::LostRequest});
        scripted.worker.request({9, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 1, timeoutMs);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::NotReceived);
        scripted.slave.script({Fault::Exception2});
        scripted.worker.request({10, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 2, timeoutMs);
        QCOMPARE(scripted.outcomes[1].end, CommandEnd::NotReceived);
        const int statuses = scripted.statuses;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.statuses > statuses + 2, timeoutMs);
        QCOMPARE(scripted.slave.commandsExecuted(), 0);
    }

    // A controller without this command would refuse each repetition.
    void refusedStopIsNotSentAgain()
    {
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        scripted.slave.script({Fault::Exception2});
        scripted.worker.request({9, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 1, timeoutMs);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::NotReceived);
        QCOMPARE(scripted.slave.commandsExecuted(), 0);
    }

    // A board writes its flash for as long as two seconds.
    void stopDoesNotWaitForASave()
    {
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        scripted.slave.setBusy(1'000'000);
        scripted.worker.request({5, Command::SaveToFlash, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.slave.commandsExecuted(), 1, timeoutMs);
        const int statuses = scripted.statuses;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.statuses > statuses, timeoutMs); // with the heartbeat
        QCOMPARE(scripted.outcomes.size(), 0);
        scripted.worker.request({6, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 2, timeoutMs);
        QCOMPARE(scripted.outcomes[0].id, 5u);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::OutcomeUnknown); // its result is gone
        QCOMPARE(scripted.outcomes[1].id, 6u);
        QCOMPARE(scripted.outcomes[1].end, CommandEnd::Done);
        QCOMPARE(scripted.slave.commandsExecuted(), 2);
    }

    void commandInPiecesEndsBetweenStatuses()
    {
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        scripted.slave.setBusy(8);
        scripted.worker.request({5, Command::SaveToFlash, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.slave.commandsExecuted(), 1, timeoutMs);
        scripted.worker.request({6, Command::Home, {}}); // would take the place of the save's result
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 2, timeoutMs);
        QCOMPARE(scripted.outcomes[0].id, 5u);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::Done);
        QCOMPARE(scripted.outcomes[1].id, 6u);
        QCOMPARE(scripted.slave.commandsExecuted(), 2);
    }

    void commandInPiecesOfALostController()
    {
        Scripted scripted;
        QTRY_VERIFY_WITH_TIMEOUT(scripted.isConnected(), timeoutMs);
        scripted.slave.setBusy(1'000'000);
        scripted.worker.request({5, Command::SaveToFlash, {}});
        QTRY_COMPARE_WITH_TIMEOUT(scripted.slave.commandsExecuted(), 1, timeoutMs);
        scripted.slave.unplug();
        QTRY_COMPARE_WITH_TIMEOUT(scripted.outcomes.size(), 1, timeoutMs);
        QCOMPARE(scripted.outcomes[0].end, CommandEnd::OutcomeUnknown);
    }
};

CAMPANEL_TEST(TestHeldStop)

} // namespace test_held_stop

#include "test_held_stop.moc"
