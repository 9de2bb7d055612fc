// SPDX-License-Identifier: Apache-2.0
// Trying an output: what the panel asks for while a key is held, and what ends it. A new end is a row.
#include "tests/app/panel/access_rig.h"
#include "tests/support/test_program.h"

#include <functional>

namespace test_output_try {

using namespace campanel;
using modbus::Command;
using modbus::State;
using panel::OutputTry;
using test::AccessRig;
using test::PanelRig;
using namespace Qt::StringLiterals;

namespace {

constexpr int cutoff = 2; // cam switch 3

// Connects a controller of this register map at standstill.
void connectWith(PanelRig& rig, int mapMinor = modbus::tryOutputMapMinor)
{
    rig.connectIdle();
    link::LinkReport report;
    report.state = link::LinkState::Connected;
    report.portName = u"/dev/fake"_s;
    report.identity = test::FakeLink::identity();
    report.identity->mapMinor = static_cast<std::uint16_t>(mapMinor);
    emit rig.link.reported(report);
}

void become(PanelRig& rig, State state, std::uint16_t warningBits = 0)
{
    rig.link.status.state = state;
    rig.link.status.warningBits = warningBits;
    rig.link.sendStatus(rig.now);
}

void answer(PanelRig& rig, link::CommandEnd end = link::CommandEnd::Done,
            modbus::Refusal reason = modbus::Refusal::None)
{
    emit rig.link.commandEnded({rig.link.requests.last().id, Command::TryOutput, end, reason, std::nullopt});
}

// Returns the outputs that were asked to be on, and as -1 those to be off.
QList<int> asked(const PanelRig& rig)
{
    QList<int> outputs;
    for (const link::CommandRequest& request : rig.link.requests) {
        if (request.command == Command::TryOutput)
            outputs << (request.arguments.argument1 != 0 ? request.arguments.argument0 : -1);
    }
    return outputs;
}

struct End {
    const char* name;
    std::function<void(PanelRig&, OutputTry&)> happens;
    const char* text;  // afterwards, the key still under the finger
    bool isOff = true; // the controller is told to switch off
};

const std::array ends{
    End{"released", [](PanelRig&, OutputTry& output) { output.release(cutoff); },
        "A filled lamp means on. Hold Try to switch an output on."},
    End{"off the screen", [](PanelRig&, OutputTry& output) { output.letGo(); },
        "A filled lamp means on. Hold Try to switch an output on."},
    End{"a second key", [](PanelRig&, OutputTry& output) { output.press(5); },
        "Release the key before you try again."},
    End{"stop", [](PanelRig& rig, OutputTry&) { rig.machine.stop(); },
        "Release the key before you try again.", false},
    End{"runs", [](PanelRig& rig, OutputTry&) { become(rig, State::Running); },
        "The machine is running. Stop it first.", false},
    End{"fault", [](PanelRig& rig, OutputTry&) { become(rig, State::Fault); },
        "The controller is in fault. Reset the fault first.", false},
    End{"emergency stop",
        [](PanelRig& rig, OutputTry&) {
            become(rig, State::Idle, modbus::RegisterInfo::bitOf(modbus::WarningBit::EmergencyStop));
        },
        "The emergency stop is pressed. Release it, then wait two seconds.", false},
    End{"line lost", [](PanelRig& rig, OutputTry&) { rig.link.becomeLost(); }, nullptr, false},
    End{"refused",
        [](PanelRig& rig, OutputTry&) {
            answer(rig, link::CommandEnd::Refused, modbus::Refusal::NotStandstill);
        },
        "Try output was refused. This is only possible at standstill. Stop the machine first.", false},
    End{"not sent", [](PanelRig& rig, OutputTry&) { answer(rig, link::CommandEnd::NotSent); },
        "Try output was not sent: there is no connection to the controller.", false},
};

} // namespace

class TestOutputTry : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void heldOutputIsAskedForAgain()
    {
        PanelRig rig;
        connectWith(rig);
        OutputTry& output = *rig.maintenance.outputTry();
        QVERIFY(output.offered());
        QVERIFY(output.possible());
        output.press(cutoff);
        QCOMPARE(output.held(), cutoff);
        QCOMPARE(output.text(), u"Cam switch 3 is on while you hold the key."_s);
        QCOMPARE(asked(rig), QList{cutoff});
        QTest::qWait(500);
        QCOMPARE(asked(rig), QList{cutoff}); // one request at a time
        for (int count = 2; count < 5; ++count) {
            answer(rig);
            QTRY_COMPARE(asked(rig), QList<int>(count, cutoff));
        }
        answer(rig, link::CommandEnd::NotReceived); // the next one may come through
        QTRY_COMPARE(asked(rig), QList<int>(5, cutoff));
        output.release(cutoff);
        QCOMPARE(output.held(), -1);
        QCOMPARE(asked(rig).last(), -1);
        QTest::qWait(400);
        QCOMPARE(asked(rig).size(), 6);
    }

    void whateverElseHappensEndsIt_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < ends.size(); ++i)
            QTest::newRow(ends[i].name) << static_cast<int>(i);
    }

    void whateverElseHappensEndsIt()
    {
        QFETCH(int, row);
        const End& end = ends[static_cast<std::size_t>(row)];
        PanelRig rig;
        connectWith(rig);
        OutputTry& output = *rig.maintenance.outputTry();
        output.press(cutoff);
        end.happens(rig, output);
        QCOMPARE(output.held(), -1);
        QCOMPARE(asked(rig), end.isOff ? QList({cutoff, -1}) : QList{cutoff});
        if (end.text)
            QCOMPARE(output.text(), QLatin1String(end.text));
        become(rig, State::Idle); // nothing comes on again
        QTest::qWait(400);
        QCOMPARE(output.held(), -1);
        QCOMPARE(asked(rig).count(cutoff), 1);
    }

    void blockedKeySaysWhy()
    {
        PanelRig rig;
        connectWith(rig);
        OutputTry& output = *rig.maintenance.outputTry();
        become(rig, State::Running);
        QVERIFY(!output.possible());
        QVERIFY(!output.blocked());
        QCOMPARE(output.text(), u"A filled lamp means on. Outputs can be tried at standstill."_s);
        output.press(cutoff);
        QVERIFY(output.blocked());
        QCOMPARE(output.text(), u"The machine is running. Stop it first."_s);
        output.release(cutoff);
        QCOMPARE(asked(rig), QList<int>());
    }

    void olderControllersDoNotOfferIt()
    {
        PanelRig rig;
        connectWith(rig, modbus::tryOutputMapMinor - 1);
        const OutputTry& output = *rig.maintenance.outputTry();
        QVERIFY(!output.offered());
        QCOMPARE(output.text(),
                 u"A filled lamp means on. This controller cannot try outputs; update its firmware."_s);
    }

    void techniciansOnlyAndInTheTrail()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        connectWith(rig);
        OutputTry& output = *rig.maintenance.outputTry();
        output.press(cutoff);
        QCOMPARE(asked(rig), QList<int>());
        output.release(cutoff);
        rig.logIn(u"Bo"_s, u"1470"_s);
        output.press(cutoff);
        QCOMPARE(asked(rig), QList{cutoff});
        answer(rig);
        output.release(cutoff);
        const auto entries = rig.entries();
        const auto& begun = entries[entries.size() - 2];
        QCOMPARE(begun.what, u"command.try_output"_s);
        QCOMPARE(begun.after, u"Switch3"_s);
        QCOMPARE(entries.last().what, u"command.try_output_end"_s);
        QCOMPARE(entries.last().before, u"Switch3"_s);
        QCOMPARE(entries.last().outcome, u"released"_s);
    }
};

CAMPANEL_TEST(TestOutputTry)

} // namespace test_output_try

#include "test_output_try.moc"
