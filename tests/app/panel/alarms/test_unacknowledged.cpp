// SPDX-License-Identifier: Apache-2.0
// An occurrence that nobody has acknowledged stays in the list, over a repetition and over a restart.
#include "tests/app/panel/alarm_rig.h"
#include "tests/support/test_program.h"

namespace test_unacknowledged {

using namespace campanel;
using namespace std::chrono_literals;
using store::AlarmRow;
using test::AlarmRig;
using Lines = QStringList;

constexpr unsigned jam = 1U << static_cast<unsigned>(modbus::FaultBit::FollowingError);
constexpr unsigned flash = 1U << static_cast<unsigned>(modbus::WarningBit::FlashSlotInvalid);

// Lets the alarm come and go `times` times, so far apart that each is an occurrence of its own.
void comeAndGo(AlarmRig& rig, void (AlarmRig::*set)(unsigned), unsigned bit, int times)
{
    for (int i = 0; i < times; ++i) {
        (rig.*set)(bit);
        rig.pass(1s);
        (rig.*set)(0);
        rig.pass(60s);
    }
}

class TestUnacknowledged : public QObject {
    Q_OBJECT

private slots:
    void eachOccurrenceIsInTheListUntilItIsAcknowledged()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        comeAndGo(rig, &AlarmRig::setFaults, jam, 2);
        rig.setFaults(jam);
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "C-01 gone calls", "C-01 gone calls"}));
        QCOMPARE(rig.alarms->active(), 1);
        QCOMPARE(rig.alarms->unacknowledged(), 3);
        QVERIFY(rig.alarms->live()->row(2).alarm.raisedMs < rig.alarms->live()->row(1).alarm.raisedMs);
        rig.alarms->acknowledge(1); // and the one before it
        QCOMPARE(rig.live(), Lines{"C-01 active calls"});
        rig.alarms->acknowledgeAll();
        rig.setFaults(0);
        QCOMPARE(rig.live(), Lines());
        QTRY_COMPARE(rig.logged().size(), 3);
        for (const AlarmRow& row : rig.logged())
            QVERIFY(row.acknowledgedMs > 0);
    }

    void shelvingAnswersTheOccurrencesBefore()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        comeAndGo(rig, &AlarmRig::setWarnings, flash, 2);
        rig.setWarnings(flash);
        QCOMPARE(rig.live().size(), 3);
        rig.alarms->showLive(0);
        rig.alarms->shelveShown(1);
        QCOMPARE(rig.live(), Lines{"W-03 active shelved"});
        QTRY_COMPARE(rig.logged().size(), 3);
        for (const AlarmRow& row : rig.logged())
            QTRY_VERIFY(!row.wantsAcknowledgement);
        // Off the shelf only what is active calls.
        rig.alarms->unshelve(0);
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
    }

    void aRestartLosesNone()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setWarnings(flash);
        rig.setFaults(jam);
        rig.setFaults(0);
        QCOMPARE(rig.live(), (Lines{"W-03 active calls", "C-01 gone calls"}));
        rig.alarms->acknowledge(0);
        QTRY_COMPARE(rig.logged().size(), 2);
        rig.setWarnings(0);
        rig.end();
        rig.start();
        rig.open();
        QTRY_COMPARE(rig.live(), Lines{"C-01 gone calls"});
        rig.pass(60s);
        rig.setFaults(jam);
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "C-01 gone calls"}));
        rig.alarms->acknowledgeAll();
        QCOMPARE(rig.live(), Lines{"C-01 active"});
        QTRY_COMPARE(rig.logged().size(), 3);
        for (const AlarmRow& row : rig.logged())
            QTRY_VERIFY(row.acknowledgedMs > 0);
    }

    void manyOfOneKindDoNotFillTheList()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        comeAndGo(rig, &AlarmRig::setFaults, jam, 100);
        QCOMPARE(rig.live().size(), static_cast<qsizetype>(panel::AlarmBook::unacknowledgedRows));
        QCOMPARE(rig.alarms->live()->rows().first().alarm.raisedMs,
                 rig.wall().addSecs(-61).toMSecsSinceEpoch());
        QCOMPARE(rig.alarms->live()->rows().last().alarm.raisedMs, rig.day.toMSecsSinceEpoch());
        rig.alarms->acknowledgeAll();
        QCOMPARE(rig.live(), Lines());
        QTRY_COMPARE(rig.logged().size(), 100);
        for (const AlarmRow& row : rig.logged())
            QTRY_VERIFY(row.acknowledgedMs > 0);
    }
};

CAMPANEL_TEST(TestUnacknowledged)

} // namespace test_unacknowledged

#include "test_unacknowledged.moc"
