// SPDX-License-Identifier: Apache-2.0
// The list of reasons, the shifts and the other settings of stops, as the level Service edits them.
#include "app/panel/stops/stop_setup.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_reasons {

using namespace campanel;
using panel::ReasonEditor;
using panel::StopSetup;

namespace {

struct Rig {
    test::PanelRig panel;
    StopSetup setup{panel.settings};
    ReasonEditor& reasons{*setup.reasons()};

    [[nodiscard]] QString text(const char* name) const
    {
        return panel.settings.values().text(name == std::string_view("starts")
                                                ? panel::Setting("stops.shift_starts")
                                                : panel::Setting("stops.reasons"));
    }
};

} // namespace

class TestReasons : public QObject {
    Q_OBJECT

private slots:
    void reasonsAreAddedRenamedAndRemoved()
    {
        Rig rig;
        QCOMPARE(rig.reasons.rows()->count(), 8);
        QVERIFY(!rig.reasons.canAdd());
        QVERIFY(!rig.reasons.isOwn());
        rig.reasons.remove(7);
        QVERIFY(rig.reasons.canAdd());
        QVERIFY(rig.reasons.isOwn());
        QVERIFY(!rig.reasons.problemOf(-1, QStringLiteral(" ")).isEmpty());
        QVERIFY(!rig.reasons.problemOf(-1, QStringLiteral("a/b")).isEmpty());
        QVERIFY(!rig.reasons.problemOf(-1, QStringLiteral("Cleaning")).isEmpty()); // the words of "cleaning"
        QVERIFY(!rig.reasons.problemOf(-1, QString(40, u'x')).isEmpty());
        rig.reasons.add(QStringLiteral(" Fork  lift "));
        QCOMPARE(rig.reasons.rows()->row(7).text(), QStringLiteral("Fork lift"));
        rig.reasons.togglePlanned(7);
        QVERIFY(rig.reasons.rows()->row(7).isPlanned());
        rig.reasons.openGroup(7);
        QCOMPARE(rig.reasons.groupText(), QStringLiteral("Fork lift"));
        rig.reasons.add(QStringLiteral("Empty"));
        rig.reasons.add(QStringLiteral("Late"));
        rig.reasons.rename(1, QStringLiteral("Too late"));
        QVERIFY2(rig.text("reasons").endsWith(
                     QStringLiteral("planned:Fork lift\nFork lift/Empty\nFork lift/Too late")),
                 qPrintable(rig.text("reasons")));
        rig.reasons.closeGroup();
        rig.reasons.rename(7, QStringLiteral("Truck"));
        QVERIFY(rig.text("reasons").contains(QStringLiteral("\nTruck/Empty\n")));
        QVERIFY(rig.reasons.rows()->row(7).opens);
        rig.reasons.restoreStandard();
        QVERIFY(!rig.reasons.isOwn());
        QCOMPARE(rig.text("reasons"), QString());
    }

    void theLastGroupStays()
    {
        Rig rig;
        for (int i = 0; i < 12; ++i)
            rig.reasons.remove(0);
        QCOMPARE(rig.reasons.rows()->count(), 1);
    }

    void shiftsKeepTheirOrder()
    {
        Rig rig;
        QCOMPARE(rig.setup.starts()->count(), 3);
        rig.setup.moveStart(0, -60);
        rig.setup.moveStart(1, 15);
        QCOMPARE(rig.text("starts"), QStringLiteral("05:00 14:15 22:00"));
        rig.setup.moveStart(2, 120); // not over midnight
        rig.setup.moveStart(1, -600);
        QCOMPARE(rig.text("starts"), QStringLiteral("05:00 14:15 22:00"));
        rig.setup.addStart(); // halves the longest
        QCOMPARE(rig.text("starts"), QStringLiteral("05:00 09:30 14:15 22:00"));
        for (int i = 0; i < 6; ++i)
            rig.setup.removeStart(0);
        QCOMPARE(rig.text("starts"), QStringLiteral("22:00"));
        for (int i = 0; i < 9; ++i)
            rig.setup.addStart();
        QCOMPARE(rig.setup.starts()->count(), panel::maxShifts);
        QVERIFY(!rig.setup.canAddStart());
    }

    void oneWorkingDayStays()
    {
        Rig rig;
        QCOMPARE(rig.setup.daysText(), QStringLiteral("every day"));
        for (const int day : {6, 7, 9, 0})
            rig.setup.toggleDay(day);
        QCOMPARE(rig.setup.workingDays(), QList<int>({1, 2, 3, 4, 5}));
        for (const int day : {1, 2, 3, 4, 5})
            rig.setup.toggleDay(day);
        QCOMPARE(rig.setup.workingDays(), QList<int>{5});
        rig.setup.toggleDay(1);
        QCOMPARE(rig.setup.workingDays(), QList<int>({1, 5}));
    }

    void onlyServiceChangesThem()
    {
        Rig rig;
        rig.panel.machine.accessCheck().setLevel(panel::Level::Technician);
        rig.setup.moveStart(0, 15);
        rig.setup.toggleDay(1);
        rig.reasons.remove(0);
        rig.panel.settings.setting(QStringLiteral("stops.ask_after_seconds"))->set(10);
        rig.panel.settings.setting(QStringLiteral("stops.ideal_rate"))->set(10);
        QCOMPARE(rig.text("starts"), QStringLiteral("06:00 14:00 22:00"));
        QCOMPARE(rig.setup.workingDays().size(), 7);
        QCOMPARE(rig.reasons.rows()->count(), 8);
        QCOMPARE(rig.panel.settings.setting(QStringLiteral("stops.ask_after_seconds"))->text(),
                 QStringLiteral("60"));
        rig.panel.machine.accessCheck().setLevel(panel::Level::Service);
        rig.panel.settings.setting(QStringLiteral("stops.ask_after_seconds"))->set(10);
        QCOMPARE(rig.panel.settings.setting(QStringLiteral("stops.ask_after_seconds"))->text(),
                 QStringLiteral("10"));
        QVERIFY(!rig.panel.settings.setting(QStringLiteral("stops.ask_after_seconds"))->check(0).isEmpty());
    }

    void everyReasonOfTheStandardListHasWords()
    {
        for (const panel::StopReason& each : panel::stopReasonsIn({})) {
            const QString part = each.name.isEmpty() ? each.group : each.name;
            QVERIFY2(panel::StopWords::reasonPart(part) != part, qPrintable(part));
        }
    }

    void durations()
    {
        QCOMPARE(panel::StopWords::duration(999), QStringLiteral("0 s"));
        QCOMPARE(panel::StopWords::duration(59'999), QStringLiteral("59 s"));
        QCOMPARE(panel::StopWords::duration(60'000), QStringLiteral("1 min"));
        QCOMPARE(panel::StopWords::duration(3'900'000), QStringLiteral("1 h 05 min"));
    }
};

CAMPANEL_TEST(TestReasons)

} // namespace test_reasons

#include "test_reasons.moc"
