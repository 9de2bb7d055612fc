// SPDX-License-Identifier: Apache-2.0
// Alarms come, are acknowledged, return, are repeated, flood, are shelved, and outlive the panel.
#include "alarm_fill.h"
#include "tests/app/panel/alarm_rig.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QAbstractItemModelTester>
#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTranslator>

namespace test_alarms {

using namespace campanel;
using namespace std::chrono_literals;
using store::AlarmRow;
using test::AlarmRig;

namespace {

constexpr unsigned jam = 1U << static_cast<unsigned>(modbus::FaultBit::FollowingError);
constexpr unsigned tooFast = 1U << static_cast<unsigned>(modbus::FaultBit::MasterTooFast);
constexpr unsigned notHomed = 1U << static_cast<unsigned>(modbus::WarningBit::NotHomed);
constexpr unsigned emergencyStop = 1U << static_cast<unsigned>(modbus::WarningBit::EmergencyStop);
constexpr unsigned flash = 1U << static_cast<unsigned>(modbus::WarningBit::FlashSlotInvalid);
constexpr unsigned marksLost = 1U << static_cast<unsigned>(modbus::WarningBit::MarksLost);

using Lines = QStringList;

} // namespace

class TestAlarms : public QObject {
    Q_OBJECT

private slots:
    void filteredHistoryTakesOnlyWhatMatches()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        panel::AlarmHistory& history = *rig.alarms->history();
        history.filter()->setId(QStringLiteral("C-07"));
        history.setWatched(true);
        QTRY_VERIFY(!history.loading());
        rig.setFaults(jam);
        QTRY_COMPARE(rig.logged().size(), 1);
        QCOMPARE(history.rows()->count(), 0);
        rig.setFaults(jam | tooFast);
        QTRY_COMPARE(history.rows()->count(), 1);
        QCOMPARE(history.rows()->row(0).code(), QStringLiteral("C-07"));
        history.filter()->clear();
        QTRY_COMPARE(history.rows()->count(), 2);
        history.filter()->setWord(panel::AlarmWords::title(QStringLiteral("C-01")).left(9).toUpper());
        QTRY_COMPARE(history.rows()->count(), 1);
        QTRY_COMPARE(history.rows()->row(0).code(), QStringLiteral("C-01"));
    }

    void acknowledgingSilencesTheMachine()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.identity = test::FakeLink::identity();
        report.identity->mapMinor = modbus::mapMinor;
        emit rig.panel.link.reported(report);
        const auto silenced = [&rig] {
            return std::ranges::count_if(rig.panel.link.requests, [](const auto& request) {
                return request.command == modbus::Command::Acknowledge;
            });
        };
        rig.setFaults(jam);
        QTRY_COMPARE(rig.live().size(), 1);
        QCOMPARE(silenced(), 0);
        rig.alarms->acknowledge(0);
        QCOMPARE(silenced(), 1);
        rig.setFaults(jam | tooFast);
        QTRY_COMPARE(rig.live().size(), 2);
        rig.alarms->acknowledgeAll();
        QCOMPARE(silenced(), 2);
    }

    void clockThatWasSetBackOrNotSetIsMarked()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setFaults(jam);
        QTRY_COMPARE(rig.logged().size(), 1);
        QVERIFY(!rig.logged()[0].isClockDoubtful);
        rig.day = rig.day.addSecs(-3600);
        rig.setFaults(jam | tooFast);
        QTRY_COMPARE(rig.logged().size(), 2);
        QVERIFY(rig.logged()[0].isClockDoubtful);
        QCOMPARE(rig.live().size(), 2);
        for (const panel::AlarmListRow& row : rig.alarms->live()->rows())
            QCOMPARE(row.clockNote().isEmpty(), row.code() == QLatin1String("C-01"));
        rig.day = rig.day.addSecs(7200);
        rig.setWarnings(flash);
        QTRY_COMPARE(rig.logged().size(), 3);
        QVERIFY(!rig.logged()[0].isClockDoubtful);
        rig.records->setClockState([] { return store::ClockState::NotSet; });
        rig.setWarnings(flash | marksLost);
        QTRY_COMPARE(rig.logged().size(), 4);
        QVERIFY(rig.logged()[0].isClockDoubtful);
    }

    void comesIsAcknowledgedAndGoes()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.panel.machine.accessCheck().setLevel(panel::Level::Service, QStringLiteral("Li"));
        rig.setFaults(jam);
        QCOMPARE(rig.live(), Lines{"C-01 active calls"});
        QCOMPARE(rig.alarms->active(), 1);
        QCOMPARE(rig.alarms->unacknowledged(), 1);
        QCOMPARE(rig.alarms->callingSeverity(), panel::Alarms::Severity::Fault);
        QCOMPARE(rig.alarms->urgentCode(), "C-01");
        QVERIFY(!rig.alarms->seen());
        rig.pass(5s);
        rig.alarms->acknowledge(0);
        QCOMPARE(rig.live(), Lines{"C-01 active"});
        QVERIFY(rig.alarms->seen());
        rig.pass(5s);
        rig.setFaults(0);
        QCOMPARE(rig.live(), Lines());
        QVERIFY(!rig.alarms->seen());
        QTRY_COMPARE(rig.logged().size(), 1);
        QTRY_COMPARE(rig.logged()[0].end, AlarmRow::End::Returned);
        const AlarmRow row = rig.logged()[0];
        QCOMPARE(row.code, "C-01");
        QCOMPARE(row.raisedMs, rig.day.toMSecsSinceEpoch());
        QCOMPARE(row.acknowledgedMs, row.raisedMs + 5000);
        QCOMPARE(row.acknowledgedBy, "Li");
        QCOMPARE(row.returnedMs, row.raisedMs + 10'000);
        QCOMPARE(row.count, 1);
    }

    void goneUnseenStaysUntilAcknowledged()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setFaults(jam);
        rig.setFaults(0);
        QCOMPARE(rig.live(), Lines{"C-01 gone calls"});
        QCOMPARE(rig.alarms->active(), 0);
        QCOMPARE(rig.alarms->unacknowledged(), 1);
        QVERIFY(rig.alarms->urgentCode().isEmpty());
        rig.alarms->acknowledgeAll();
        QCOMPARE(rig.live(), Lines());
    }

    void mostUrgentIsFirst()
    {
        AlarmRig rig;
        const QAbstractItemModelTester rowsAreTold(rig.alarms->live());
        const QSignalSpy reset(rig.alarms->live(), &QAbstractItemModel::modelReset);
        rig.panel.connectIdle();
        rig.setWarnings(notHomed | flash);
        QCOMPARE(rig.live(), (Lines{"W-03 active calls", "W-02 active"}));
        const QPersistentModelIndex asked(rig.alarms->live()->index(0));
        rig.setFaults(tooFast);
        QCOMPARE(rig.live(), (Lines{"C-07 active calls", "W-03 active calls", "W-02 active"}));
        QCOMPARE(asked.row(), 1);
        QCOMPARE(rig.alarms->urgentCode(), "C-07");
        rig.alarms->acknowledge(0);
        QCOMPARE(rig.live(), (Lines{"W-03 active calls", "C-07 active", "W-02 active"}));
        QCOMPARE(asked.row(), 0);
        QCOMPARE(rig.alarms->callingSeverity(), panel::Alarms::Severity::Warning);
        QCOMPARE(rig.alarms->urgentCode(), "C-07");
        rig.setFaults(0);
        rig.setWarnings(notHomed);
        rig.alarms->acknowledgeAll();
        QCOMPARE(rig.live(), Lines{"W-02 active"});
        QVERIFY2(rig.alarms->urgentCode().isEmpty(), "a notice is not urgent");
        QVERIFY(!asked.isValid());
        QVERIFY2(reset.isEmpty(), "a list that is made anew loses its place and what is pressed");
    }

    void comingAndGoingQuicklyIsOneOccurrence()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        for (int i = 0; i < 7; ++i) {
            rig.setFaults(jam);
            rig.pass(100ms);
            rig.setFaults(0);
            rig.pass(9s);
        }
        rig.pass(2s);
        rig.setFaults(jam);
        QTRY_COMPARE(rig.logged().size(), 2);
        QCOMPARE(rig.logged()[1].count, 7);
        QCOMPARE(rig.logged()[0].count, 1);
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "C-01 gone calls"}));
        rig.alarms->acknowledgeAll();
        QTRY_VERIFY(rig.logged()[1].acknowledgedMs > 0);
        QVERIFY(rig.logged()[0].acknowledgedMs > 0);
    }

    void chatterOfAnAcknowledgedOneDoesNotCallAgain()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setFaults(jam);
        rig.alarms->acknowledgeAll();
        rig.setFaults(0);
        rig.pass(3s);
        rig.setFaults(jam);
        QCOMPARE(rig.live(), Lines{"C-01 active"});
        rig.setFaults(0);
        rig.pass(11s);
        rig.setFaults(jam);
        QCOMPARE(rig.live(), Lines{"C-01 active calls"});
    }

    void floodIsBounded_data()
    {
        QTest::addColumn<int>("apartMs");
        QTest::newRow("a millisecond apart") << 1;
        QTest::newRow("too far apart to be the same") << 11'000;
    }
    void floodIsBounded()
    {
        QFETCH(int, apartMs);
        constexpr int changes = 100'000;
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        QSignalSpy shown(rig.alarms.get(), &panel::Alarms::changed);
        QElapsedTimer timer;
        timer.start();
        for (int i = 0; i < changes; ++i) {
            rig.setFaults(i % 2 == 0 ? jam : 0);
            rig.pass(std::chrono::milliseconds(apartMs));
        }
        qInfo("%d changes: %lld ms", changes, timer.elapsed());
        QVERIFY(rig.live().size() <= panel::AlarmBook::unacknowledgedRows);
        QCOMPARE(rig.live().first(), "C-01 gone calls");
        QVERIFY2(shown.size() < 50, "what nobody can see is not shown");
        rig.end();
        rig.start();
        rig.open();
        qint64 times = 0;
        qint64 rows = 0;
        rig.records->store().run(
            this,
            [](store::Database& database) {
                return store::alarmTable().page(database, 0, changes).value_or(QList<AlarmRow>());
            },
            [&](const QList<AlarmRow>& all) {
                rows = all.size();
                for (const AlarmRow& row : all)
                    times += row.count;
            });
        QTRY_VERIFY(rows > 0);
        QCOMPARE(times, qint64(changes / 2)); // each one is counted
        QVERIFY2(rows <= qint64(panel::AlarmBook::waitingRows), qPrintable(QString::number(rows)));
    }

    void linkHasAMomentToComeUp()
    {
        AlarmRig rig;
        rig.alarms->watch().setPatienceMs(50);
        link::LinkReport searching;
        searching.simulated = false;
        searching.error = modbus::LinkError{modbus::LinkErrorKind::PortAbsent, "/dev/fake", {}, {}, 0};
        emit rig.panel.link.reported(searching);
        QCOMPARE(rig.live(), Lines());
        QTRY_COMPARE(rig.live(), Lines{"L-01 active calls"});
        QVERIFY(rig.alarms->live()->row(0).alarm.detail.contains(QStringLiteral("/dev/fake")));
        searching.state = link::LinkState::Connecting;
        emit rig.panel.link.reported(searching);
        QCOMPARE(rig.live(), Lines{"L-01 active calls"}); // until another state is certain
        searching.state = link::LinkState::WrongDevice;
        emit rig.panel.link.reported(searching);
        QCOMPARE(rig.live(), (Lines{"L-04 active calls", "L-01 gone calls"}));
        rig.panel.link.becomeConnected();
        rig.alarms->acknowledgeAll();
        QCOMPARE(rig.live(), Lines());
        rig.panel.link.becomeLost();
        QCOMPARE(rig.live(), Lines{"L-03 active calls"});
    }

    void scanIsNoTrouble()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        link::LinkReport scanning;
        scanning.isScanning = true;
        scanning.state = link::LinkState::Lost;
        emit rig.panel.link.reported(scanning);
        QCOMPARE(rig.live(), Lines());
    }

    void whatCannotBeSeenHasNotEnded()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setFaults(jam);
        rig.panel.link.becomeLost();
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "L-03 active calls"}));
        rig.panel.link.becomeConnected();
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "L-03 gone calls"}));
        emit rig.panel.link.reported({}); // another controller
        QCOMPARE(rig.live()[0], "C-01 gone calls");
        QTRY_COMPARE(rig.logged().size(), 2);
        QTRY_COMPARE(rig.logged()[1].end, AlarmRow::End::Unknown);
    }

    void bitThatIsNotKnownHasItsAlarm()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setFaults(0x8000);
        QCOMPARE(rig.live(), Lines{"C-99 active calls"});
        rig.alarms->showLive(0);
        QCOMPARE(rig.alarms->detail()->detail(), "0x8000 0x0000");
    }

    // Nobody without the level acknowledges, and the trail names who did.
    void whoMayOnlyLookAcknowledgesNothing()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setWarnings(flash);
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
        rig.alarms->showLive(0);
        QSignalSpy noted(rig.alarms.get(), &panel::Alarms::noted);
        const auto last = [&noted] {
            const auto entry = noted.last().first().value<store::AuditEntry>();
            return QString(entry.what + u' ' + entry.object + u' ' + entry.after);
        };
        auto& access = rig.panel.machine.accessCheck();
        access.setLevel(panel::Level::Viewer);
        rig.alarms->acknowledge(0);
        rig.alarms->acknowledgeAll();
        rig.alarms->acknowledgeShown();
        rig.alarms->shelveShown(1);
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
        QCOMPARE(noted.count(), 0);
        access.setLevel(panel::Level::Technician);
        rig.alarms->shelveShown(1);
        QCOMPARE(last(), QStringLiteral("alarm.shelve W-03 1 h"));
        access.setLevel(panel::Level::Viewer);
        rig.alarms->unshelve(0);
        rig.alarms->unshelveShown();
        QCOMPARE(rig.live(), Lines{"W-03 active shelved"});
        access.setLevel(panel::Level::Operator);
        rig.alarms->unshelve(0);
        QCOMPARE(last(), QStringLiteral("alarm.unshelve W-03 "));
        rig.alarms->acknowledgeAll();
        QCOMPARE(last(), QStringLiteral("alarm.acknowledge W-03 "));
        QCOMPARE(rig.live(), Lines{"W-03 active"});
    }

    void shelvedDoesNotCall()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setWarnings(flash);
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
        rig.alarms->showLive(0);
        QVERIFY(rig.alarms->detail()->shelvable());
        rig.alarms->shelveShown(1);
        QCOMPARE(rig.live(), Lines{"W-03 active shelved"});
        QCOMPARE(rig.alarms->active(), 0);
        QCOMPARE(rig.alarms->unacknowledged(), 0);
        QVERIFY(rig.alarms->urgentCode().isEmpty());
        rig.setWarnings(0);
        rig.pass(20s);
        QCOMPARE(rig.live(), Lines());
        rig.setWarnings(flash);
        QCOMPARE(rig.live(), Lines{"W-03 active shelved"});
        QTRY_COMPARE(rig.logged().size(), 2);
        QVERIFY(rig.logged()[0].isShelved);
        QVERIFY(rig.logged()[1].isShelved);
        rig.pass(59min);
        rig.alarms->check();
        QCOMPARE(rig.alarms->shelved()->count(), 1);
        rig.pass(1min);
        rig.alarms->check();
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
        QCOMPARE(rig.alarms->shelved()->count(), 0);
    }

    void whatStopsTheMachineIsNotShelved()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setFaults(jam);
        rig.setWarnings(marksLost | emergencyStop);
        QCOMPARE(rig.live(), (Lines{"C-01 active calls", "M-01 active calls", "W-05 active calls"}));
        for (int row = 0; row < 3; ++row) {
            rig.alarms->showLive(row);
            QVERIFY(!rig.alarms->detail()->shelvable());
            rig.alarms->shelveShown(1);
            QCOMPARE(rig.alarms->shelved()->count(), 0);
        }
        QCOMPARE(rig.alarms->unacknowledged(), 3);
    }

    // An earlier version could shelve the emergency stop.
    void aShelfOfWhatStopsTheMachineIsForgotten()
    {
        AlarmRig rig;
        rig.shelve(QStringLiteral("W-05"));
        rig.open();
        rig.panel.connectIdle();
        rig.setWarnings(emergencyStop);
        QTRY_COMPARE(rig.live(), Lines{"W-05 active calls"});
        QCOMPARE(rig.alarms->shelved()->count(), 0);
    }

    void takenOffTheShelfItCallsAgain()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setWarnings(flash);
        (void)rig.live();
        rig.alarms->showLive(0);
        rig.alarms->shelveShown(8);
        rig.alarms->unshelve(0);
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
        rig.alarms->shelveShown(8);
        rig.day = rig.day.addDays(-400); // the clock was set: otherwise the shelf would last for more than a
                                         // year
        rig.alarms->check();
        QCOMPARE(rig.live(), Lines{"W-03 active calls"});
    }

    void shelfAndLogOutliveThePanel()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        rig.setWarnings(flash);
        rig.setFaults(jam);
        (void)rig.live();
        rig.alarms->showLive(1);
        rig.alarms->shelveShown(8);
        QTRY_COMPARE(rig.logged().size(), 2);
        rig.end();
        rig.start();
        rig.open();
        QTRY_COMPARE(rig.alarms->shelved()->count(), 1);
        QTRY_COMPARE(rig.live(), (Lines{"C-01 active calls", "C-01 gone calls", "W-03 active shelved"}));
        QTRY_COMPARE(rig.logged().size(), 4);
        QCOMPARE(rig.logged()[2].end, AlarmRow::End::Unknown);
        QCOMPARE(rig.logged()[3].end, AlarmRow::End::Unknown);
        QCOMPARE(rig.logged()[0].end, AlarmRow::End::Active);
    }

    void lastChangesAreWrittenAtTheEnd()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        QTRY_COMPARE(rig.logged().size(), 0);
        rig.setFaults(jam);
        rig.end();
        rig.start();
        rig.open();
        QTRY_VERIFY(rig.logged().size() >= 1);
        QCOMPARE(rig.logged().last().end, AlarmRow::End::Unknown);
    }

    void fullDiskIsAnAlarmUntilThereIsRoom()
    {
        AlarmRig rig;
        rig.open();
        rig.records->reportError({store::StoreError::Kind::Full, QStringLiteral("x"), {}});
        QCOMPARE(rig.live(), Lines{"P-04 active calls"});
        QTRY_COMPARE(rig.live(), Lines{"P-04 gone calls"}); // its own row had space
    }

    void whatFoundNoRoomIsWrittenLater()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        const auto limit = [&](int pages) {
            bool isDone = false;
            rig.records->store().run(
                this,
                [pages](store::Database& database) {
                    return database.execute(QStringLiteral("PRAGMA max_page_count = %1").arg(pages))
                        .has_value();
                },
                [&](bool) { isDone = true; });
            QTRY_VERIFY(isDone);
        };
        limit(1); // the present number
        constexpr int occurrences = 150;
        for (int i = 0; i < occurrences; ++i) {
            rig.setFaults(jam);
            rig.setFaults(0);
            rig.pass(11s);
        }
        QTRY_COMPARE(rig.live().first(), "P-04 active calls");
        QVERIFY(rig.records->notice().contains(QStringLiteral("full")));
        QVERIFY(rig.logged().isEmpty());
        limit(100'000);
        QTRY_COMPARE_WITH_TIMEOUT(rig.live().last(), "P-04 gone calls", 8000);
        QTRY_COMPARE(rig.logged().size(), occurrences + 1);
        QTRY_COMPARE(rig.logged()[0].end, AlarmRow::End::Returned);
    }

    void damagedMemoryIsToldOnce()
    {
        AlarmRig rig;
        rig.end();
        QFile file(rig.folder.filePath(QStringLiteral("campanel.sqlite")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(9000, 'x')) == 9000);
        file.close();
        rig.start();
        rig.open();
        QTRY_COMPARE(rig.live(), Lines{"P-02 gone calls"});
        QTRY_COMPARE(rig.logged().size(), 1);
    }

    void damagedSettingsAreLogged()
    {
        AlarmRig rig;
        rig.end();
        const QString path = rig.folder.filePath(QStringLiteral("settings.ini"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("; damaged") > 0);
        file.close();
        QTest::ignoreMessage(QtWarningMsg,
                             QRegularExpression(QStringLiteral("settings file .* no good copy")));
        panel::Settings settings(path, nullptr);
        rig.records = std::make_unique<panel::DatabaseService>(rig.folder.path(), nullptr);
        rig.alarms = std::make_unique<panel::Alarms>(rig.panel.machine, rig.panel.editor, *rig.records,
                                                     settings, nullptr);
        rig.open();
        QTRY_COMPARE(rig.logged().size(), 1);
        QCOMPARE(rig.logged()[0].code, "P-10");
        QCOMPARE(rig.logged()[0].detail, settings.notice());
    }

    void aTouchscreenThatDisappearsIsAnAlarm()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        int touchscreens = 0;
        rig.alarms->watch().setTouchscreenCount([&touchscreens] { return touchscreens; });
        rig.alarms->check();
        QCOMPARE(rig.live(), QStringList()); // a desktop
        touchscreens = 1;
        rig.alarms->check();
        QCOMPARE(rig.live(), QStringList());
        touchscreens = 0;
        rig.alarms->check();
        rig.alarms->check();
        QCOMPARE(rig.live(), QStringList{"P-11 active calls"});
        touchscreens = 1;
        rig.alarms->check();
        QCOMPARE(rig.live(), QStringList{"P-11 gone calls"});
    }

    void memoryThatCannotBeOpenedStaysAnAlarm()
    {
        AlarmRig rig;
        panel::DatabaseService records(QStringLiteral("/proc/no/such/folder"), nullptr);
        panel::Alarms alarms(rig.panel.machine, rig.panel.editor, records, rig.panel.settings, nullptr);
        records.open();
        QTRY_COMPARE(alarms.urgentCode(), "P-03");
        QVERIFY(alarms.live()->row(0).alarm.detail.contains(QStringLiteral("/proc/no/such/folder")));
    }

    void aLostDiskStaysAFaultAndItsFolderIsLeftAlone()
    {
        AlarmRig rig;
        const QTemporaryDir folder;
        panel::DatabaseService records(folder.path(), nullptr);
        panel::Alarms alarms(rig.panel.machine, rig.panel.editor, records, rig.panel.settings, nullptr);
        records.noteDiskLost(QStringLiteral("/dev/vda3: no such partition"));
        records.open();
        QTRY_COMPARE(alarms.urgentCode(), "P-12");
        QVERIFY(alarms.live()->row(0).alarm.detail.contains(QStringLiteral("/dev/vda3")));
        QVERIFY(records.isDiskLost());
        QVERIFY(records.notice().contains(QStringLiteral("/dev/vda3")));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("campanel.sqlite"))));
        records.dismissNotice();
        QCOMPARE(records.notice(), QString());
        QCOMPARE(alarms.urgentCode(), "P-12");
    }

    void historyIsReadByPagesAndFollows()
    {
        AlarmRig rig;
        rig.open();
        rig.panel.connectIdle();
        bool isFilled = false;
        rig.records->store().run(
            this,
            [](store::Database& database) { return test::fillAlarmLog(database, store::AlarmLog::capacity); },
            [&](bool filled) { isFilled = filled; });
        QTRY_VERIFY(isFilled);
        rig.end();
        rig.start();
        rig.open();
        panel::AlarmHistory& history = *rig.alarms->history();
        QElapsedTimer timer;
        timer.start();
        history.setWatched(true);
        QVERIFY(history.loading());
        QTRY_VERIFY(!history.loading());
        qInfo("100 000 alarms shown after %lld ms, the opening of the database with it", timer.elapsed());
        QCOMPARE(history.rows()->count(), store::logPageRows);
        QCOMPARE(history.rows()->row(0).alarm.id, store::AlarmLog::capacity);
        QVERIFY(history.rows()->canFetchMore({}));
        history.rows()->fetchMore({});
        QVERIFY(!history.rows()->canFetchMore({}));
        QTRY_COMPARE(history.rows()->count(), 2 * store::logPageRows);
        QCOMPARE(history.rows()->rows().last().id(), store::AlarmLog::capacity - 2 * store::logPageRows + 1);

        rig.setFaults(jam);
        QTRY_COMPARE(history.rows()->count(), 2 * store::logPageRows + 1);
        QCOMPARE(history.rows()->row(0).alarm.code, "C-01");
        QCOMPARE(history.rows()->row(0).alarm.id, store::AlarmLog::capacity + 1);
        QCOMPARE(history.rows()->row(0).alarm.end, AlarmRow::End::Active);
        rig.setFaults(0);
        QTRY_COMPARE(history.rows()->row(0).alarm.end, AlarmRow::End::Returned);
        rig.alarms->showHistory(0);
        QVERIFY(rig.alarms->detail()->calls());
        rig.alarms->acknowledgeShown();
        QVERIFY(!rig.alarms->detail()->calls());
        QTRY_VERIFY(history.rows()->row(0).alarm.acknowledgedMs > 0);
        history.setWatched(false);
        QCOMPARE(history.rows()->count(), 0);
    }

    void textsFollowTheLanguage()
    {
        AlarmRig rig;
        rig.panel.connectIdle();
        rig.setFaults(jam);
        (void)rig.live();
        const auto title = [&] { return rig.alarms->live()->row(0).title(); };
        QCOMPARE(title(), "Following error too large");
        QSignalSpy changed(rig.alarms->live(), &panel::AlarmList::dataChanged);
        QTranslator translator;
        QVERIFY(translator.load(campanel::test::languageFile("zh_CN")));
        QVERIFY(QCoreApplication::installTranslator(&translator));
        QCOMPARE(title(), "跟随误差过大");
        QCOMPARE(rig.alarms->urgentTitle(), "跟随误差过大");
        QCOMPARE(changed.size(), 1);
        QCOMPARE(rig.panel.machine.alarmText(), "轴跟不上设定值。请检查是否卡阻，然后复位故障并回零。");
        QCoreApplication::removeTranslator(&translator);
    }
};

CAMPANEL_TEST(TestAlarms)

} // namespace test_alarms

#include "test_alarms.moc"
