// SPDX-License-Identifier: Apache-2.0
// The panel's permit on its way to the real controller program: with each heartbeat, and before a command
// that needs it.
#include "link_panel.h"
#include "modbus/map/codec.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

namespace test_permit {

using namespace campanel;
using modbus::Command;
using modbus::Refusal;
using modbus::State;
using test::ControllerProcess;
using test::Panel;
using test::timeoutMs;

namespace {

// Sends a Start and returns its outcome.
link::CommandOutcome start(Panel& panel)
{
    panel.outcomes.clear();
    panel.link.request({1, Command::Start, {}});
    const bool isAnswered = QTest::qWaitFor([&panel] { return !panel.outcomes.isEmpty(); }, timeoutMs);
    return isAnswered ? panel.outcomes.first() : link::CommandOutcome{};
}

void stop(Panel& panel)
{
    QTRY_VERIFY_WITH_TIMEOUT(!panel.isIn(State::Ready), timeoutMs);
    panel.link.request({2, Command::StopNow, {}});
    QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Ready), timeoutMs);
}

void install(Panel& panel)
{
    QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
    panel.link.download(test::imageOf(250).registers);
    QTRY_COMPARE_WITH_TIMEOUT(panel.download.stage, link::DownloadStage::Active, timeoutMs);
}

// The registers written by each status request.
QList<int> writtenByExchanges(const Panel& panel)
{
    QList<int> counts;
    for (const modbus::FrameRecord& frame : panel.frames) {
        const auto bytes = frame.bytes();
        if (frame.isSent() && bytes.size() > 9 && bytes[1] == 23 && bytes[6] == 0x02 && bytes[7] == 0x00)
            counts << (bytes[8] << 8 | bytes[9]);
    }
    return counts;
}

} // namespace

class TestPermit : public QObject {
    Q_OBJECT

private slots:
    void aChangeReachesTheControllerBeforeTheStart()
    {
        const ControllerProcess controller;
        Panel panel(test::portSettings(controller.port()));
        install(panel);
        bool isWritten = false;
        panel.link.exchange({0, "parameter.permit_needed", 1.0},
                            {&panel, [&isWritten](const link::ParameterOutcome& outcome) {
                                 isWritten = outcome.end == link::ParameterEnd::Done;
                             }});
        QTRY_VERIFY_WITH_TIMEOUT(isWritten, timeoutMs);
        QCOMPARE(start(panel).reason, Refusal::NotWarm);
        for (int i = 0; i < 5; ++i) {
            panel.link.setPermit(modbus::allPermits &
                                 ~(1U << static_cast<unsigned>(modbus::PermitBit::Film)));
            const link::CommandOutcome refused = start(panel);
            QCOMPARE(refused.end, link::CommandEnd::Refused);
            QCOMPARE(refused.reason, Refusal::WrongFilm);
            panel.link.setPermit(modbus::allPermits);
            QCOMPARE(start(panel).end, link::CommandEnd::Done);
            stop(panel);
        }
    }

    void aPanelThatHangsPermitsNothing()
    {
        const ControllerProcess controller;
        Panel panel(test::portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        const auto permit = [&panel] {
            panel.reads.clear();
            panel.link.readRegisters({0, modbus::registerNamed("exchange.permit").address, 1});
            const bool isRead = QTest::qWaitFor([&panel] { return !panel.reads.isEmpty(); }, timeoutMs);
            return isRead && panel.reads.first().end == link::ReadEnd::Done
                       ? int{panel.reads.first().registers.front()}
                       : -1;
        };
        panel.link.setPermit(modbus::allPermits);
        QTRY_COMPARE_WITH_TIMEOUT(permit(), int{modbus::allPermits}, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(permit(), 0, timeoutMs); // it was not repeated
    }

    void anOlderControllerGetsThreeRegisters_data()
    {
        QTest::addColumn<int>("minor");
        QTest::addColumn<int>("registers");
        QTest::newRow("map 1.4") << 4 << 3;
        QTest::newRow("newest map") << int{modbus::mapMinor} << 4;
    }

    void anOlderControllerGetsThreeRegisters()
    {
        QFETCH(int, minor);
        QFETCH(int, registers);
        const ControllerProcess controller({QStringLiteral("--map-minor"), QString::number(minor)});
        Panel panel(test::portSettings(controller.port()));
        panel.link.watchFrames(true);
        panel.link.setPermit(modbus::allPermits);
        install(panel);
        QCOMPARE(int{panel.report.identity->mapMinor}, minor);
        QCOMPARE(start(panel).end, link::CommandEnd::Done);
        stop(panel);
        QTRY_VERIFY_WITH_TIMEOUT(writtenByExchanges(panel).size() > 10, timeoutMs);
        const QList<int> counts = writtenByExchanges(panel);
        QVERIFY(std::ranges::all_of(counts, [registers](int count) { return count == registers; }));
    }
};

CAMPANEL_TEST(TestPermit)

} // namespace test_permit

#include "test_permit.moc"
