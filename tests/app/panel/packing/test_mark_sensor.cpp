// SPDX-License-Identifier: Apache-2.0
// The dead time of the mark sensor as a technician meets it: a machine with late sensors starts and stops,
// the field offers what was learned, and taken it is in the controller. What is true is the simulated
// sensor's.
#include "packing_machine.h"

#include "app/panel/alarms/alarm_watch.h"
#include "app/panel/records/database_service.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>

namespace test_mark_sensor {

using namespace campanel;
using panel::PackingFields;

namespace {

constexpr int starts = 12;

controller::MachineOptions lateBy(double delayMs)
{
    controller::MachineOptions options;
    options.sensors.delayMs = delayMs;
    options.film.slipPerAcceleration = 0.05;
    return options;
}

struct Machine : test::PackingMachine {
    explicit Machine(double delayMs)
        : PackingMachine(lateBy(delayMs), 300, 200)
    {
    }

    bool passUntilState(unsigned state)
    {
        for (int i = 0; i < 1200 && link.rig().core().motion.state != state; ++i)
            pass(0.05);
        return link.rig().core().motion.state == state;
    }
    bool startAndStop()
    {
        machine.start();
        const bool runs = passUntilState(CTL_STATE_RUNNING);
        pass(8);
        machine.stop();
        return runs && passUntilState(CTL_STATE_READY);
    }
    int row() { return PackingMachine::row(QStringLiteral("Mark sensor: dead time")); }
    std::uint16_t deadUs() { return parameter(CTL_REG_PARAMETER_MARK_DEAD_TIME); }
};

} // namespace

class TestMarkSensor : public QObject {
    Q_OBJECT

private slots:
    void offersWhatItLearned_data()
    {
        QTest::addColumn<double>("delayMs");
        QTest::newRow("1 ms") << 1.0;
        QTest::newRow("5 ms") << 5.0;
    }
    void offersWhatItLearned()
    {
        QFETCH(double, delayMs);
        Machine machine(delayMs);
        const int row = machine.row();
        QVERIFY(row >= 0);
        QVERIFY(machine.at(row, PackingFields::NoteRole).contains(QStringLiteral("too few marks")));
        for (int i = 0; i < starts; ++i)
            QVERIFY(machine.startAndStop());
        const QString offered = machine.at(row, PackingFields::SuggestionRole);
        QVERIFY2(std::abs(offered.toDouble() - delayMs) < 0.1,
                 qPrintable(offered + machine.at(row, PackingFields::NoteRole)));
        QCOMPARE(machine.deadUs(), std::uint16_t{0}); // nobody has taken it

        machine.fields().takeSuggestion(row);
        machine.pass(1);
        QCOMPARE(machine.deadUs(), static_cast<std::uint16_t>(std::lround(offered.toDouble() * 1000.0)));
        QVERIFY(machine.startAndStop());
        QVERIFY(machine.at(row, PackingFields::SuggestionRole).isEmpty());
        QVERIFY(machine.at(row, PackingFields::NoteRole).contains(QStringLiteral("learned: ")));
    }

    // A machine whose sensor was right when its dead time was entered; a dirty one gets slower.
    void aDriftingSensorIsAnAlarm_data()
    {
        QTest::addColumn<double>("enteredMs");
        QTest::addColumn<double>("delayMs");
        QTest::addColumn<int>("raised");
        QTest::newRow("as entered") << 1.0 << 1.0 << 0;
        QTest::newRow("slower") << 1.0 << 2.0 << 1;
        QTest::newRow("faster") << 2.0 << 1.0 << 1;
        QTest::newRow("none entered") << 0.0 << 2.0 << 0;
    }
    void aDriftingSensorIsAnAlarm()
    {
        QFETCH(double, enteredMs);
        QFETCH(double, delayMs);
        QFETCH(int, raised);
        Machine machine(delayMs);
        panel::DatabaseService records(machine.folder.path(), nullptr);
        panel::AlarmWatch alarms(machine.machine, machine.editor, records, machine.settings, nullptr);
        QObject::connect(machine.setup.sensor(), &panel::MarkSensor::driftChanged, &alarms,
                         &panel::AlarmWatch::noteSensorDrift);
        QStringList news;
        QObject::connect(&alarms, &panel::AlarmWatch::raised, this,
                         [&news](const panel::AlarmKind& kind, const QString& detail) {
                             if (kind.code() == QStringLiteral("M-06"))
                                 news << detail;
                         });
        QObject::connect(&alarms, &panel::AlarmWatch::cleared, this, [&news](const panel::AlarmKind& kind) {
            if (kind.code() == QStringLiteral("M-06"))
                news << QStringLiteral("cleared");
        });
        if (enteredMs > 0)
            machine.fields().write("parameter.mark_dead_time", enteredMs);
        machine.pass(1);
        for (int i = 0; i < starts; ++i)
            QVERIFY(machine.startAndStop());
        QVERIFY2(news.size() == raised, qPrintable(news.join(u'\n')));
        QCOMPARE(machine.deadUs(), static_cast<std::uint16_t>(enteredMs * 1000)); // nobody has changed it
        if (raised == 0)
            return;
        QVERIFY2(
            news[0].startsWith(
                QStringLiteral("Dead time of the mark sensor: entered %1.00 ms, learned ").arg(enteredMs)),
            qPrintable(news[0]));
        machine.fields().takeSuggestion(machine.row());
        machine.pass(1);
        QCOMPARE(news.size(), 2);
        QCOMPARE(news[1], QStringLiteral("cleared"));
        QVERIFY(machine.startAndStop());
        QCOMPARE(news.size(), 2);
    }

    void offersNothingForAPromptSensor()
    {
        Machine machine(0.0);
        for (int i = 0; i < starts; ++i)
            QVERIFY(machine.startAndStop());
        QVERIFY2(machine.at(machine.row(), PackingFields::SuggestionRole).isEmpty(),
                 qPrintable(machine.at(machine.row(), PackingFields::SuggestionRole)));
    }
};

CAMPANEL_TEST(TestMarkSensor)

} // namespace test_mark_sensor

#include "test_mark_sensor.moc"
