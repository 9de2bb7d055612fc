// SPDX-License-Identifier: Apache-2.0
// The table of what the state of machine and connection blocks is tried for every action in every state.
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace campanel::panel::test_availability {

using namespace Qt::StringLiterals;
using State = modbus::State;

class TestAvailability : public QObject {
    Q_OBJECT

private slots:
    // Each letter is a state in which the action is free: Idle, Ready, rUnning, Stopping, Jogging, Homing,
    // Fault; o: offline.
    void everyActionInEveryState_data()
    {
        QTest::addColumn<Action>("action");
        QTest::addColumn<QString>("freeIn");
        QTest::addRow("start") << Action::Start << u"R"_s;
        QTest::addRow("home") << Action::Home << u"R"_s;
        QTest::addRow("one bag") << Action::JogBag << u"R"_s;
        QTest::addRow("single cut") << Action::SingleCut << u"R"_s;
        QTest::addRow("take the next bag") << Action::TakeBag << u"US"_s;
        QTest::addRow("measure an axis") << Action::Measure << u"R"_s;
        QTest::addRow("jog") << Action::Jog << u"IRJ"_s;
        QTest::addRow("try an output") << Action::TryOutput << u"IR"_s;
        QTest::addRow("download") << Action::Download << u"IRUSJHF"_s;
        QTest::addRow("change machine data") << Action::ChangeMachineData << u"IR"_s;
        QTest::addRow("compare") << Action::Compare << u"IRUSJHF"_s;
        QTest::addRow("reverse the master") << Action::ReverseMaster << u"IRUSJHF"_s;
        QTest::addRow("set up marks") << Action::SetUpMarks << u"IRUSJHF"_s;
        QTest::addRow("measure marks") << Action::MeasureMarks << u"U"_s;
        for (const Action action : {Action::Diagnose, Action::RotateScreen, Action::CalibrateTouch,
                                    Action::UpdateSoftware, Action::RestoreBackup})
            QTest::addRow("of the panel, %d", static_cast<int>(action)) << action << u"IRFo"_s;
    }

    void everyActionInEveryState()
    {
        QFETCH(Action, action);
        QFETCH(QString, freeIn);
        test::PanelRig rig;
        QCOMPARE(rig.machine.blockedReason(action).isEmpty(), freeIn.contains(u'o'));
        rig.connectRunning(); // with a program
        const QList<std::pair<QChar, State>> states{
            {u'I', State::Idle},    {u'R', State::Ready},  {u'U', State::Running}, {u'S', State::Stopping},
            {u'J', State::Jogging}, {u'H', State::Homing}, {u'F', State::Fault}};
        for (const auto& [letter, state] : states) {
            rig.link.status.state = state;
            rig.link.sendStatus(rig.now);
            const QString reason = rig.machine.blockedReason(action);
            QVERIFY2(reason.isEmpty() == freeIn.contains(letter), qPrintable(letter + u": "_s + reason));
            QVERIFY2(reason.isEmpty() || reason.endsWith(u'.'), qPrintable(reason));
        }
    }

    void anInterlockBlocksStartAlone()
    {
        test::PanelRig rig;
        rig.connectRunning();
        rig.link.status.state = State::Ready;
        rig.link.sendStatus(rig.now);
        rig.machine.setStartInterlock([] { return u"Wrong film."_s; });
        QCOMPARE(rig.machine.blockedReason(Action::Start), u"Wrong film."_s);
        QCOMPARE(rig.machine.blockedReason(Action::JogBag), u"Wrong film."_s);
        QCOMPARE(rig.machine.blockedReason(Action::SingleCut), u"Wrong film."_s);
        QCOMPARE(rig.machine.blockedReason(Action::Home), QString());
    }
};

CAMPANEL_TEST(TestAvailability)

} // namespace campanel::panel::test_availability

#include "test_availability.moc"
