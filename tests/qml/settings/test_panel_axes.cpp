// SPDX-License-Identifier: Apache-2.0
// The measurement of the axes by touch: taken and left, the direction and its answer, the bag and the ruler,
// and the sentence of each end.
#include "tests/qml/panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_axes {

using namespace campanel;
using namespace Qt::StringLiterals;
using modbus::MeasureState;
using modbus::Refusal;
using Situation = looks::DemoLink::Situation;
using Step = panel::AxisMeasurement::Step;

class TestPanelAxes : public test::PanelTest {
    Q_OBJECT

    panel::AxisMeasurement& measurement() { return *m_window->panel().maintenance().measurement(); }
    modbus::MeasureStatus counted()
    {
        return {.state = MeasureState::Done,
                .turns = 5,
                .pulses = 10'237.4,
                .spread = 6.5,
                .bagPulses = 12'000.0,
                .bag = 1234};
    }
    void openMachine()
    {
        looks::DemoLink& link = m_window->link();
        link.setParameter("parameter.film_pulses", 10'000);
        link.setParameter("parameter.film_feed", 150);
        link.setParameter("parameter.flight_pulses", 20'000);
        link.show(Situation::Stopped);
        link.setMeasure(counted());
        m_window->settle();
        tap("nav_settings");
        tap("section2");
    }
    void openAxis(int row)
    {
        openMachine();
        tap("openAxes");
        m_window->tap(u"axes%1measure"_s.arg(row));
    }
    // Holds the key until it acts, which takes longer on a busy computer.
    void holdStart()
    {
        const qsizetype before = measurements();
        m_window->touch(u"axisStart"_s);
        QTRY_VERIFY(measurements() > before);
        m_window->lift();
        m_window->settle();
    }
    void turn()
    {
        holdStart();
        QTRY_VERIFY(measurement().step() != Step::Moving);
        m_window->settle();
    }
    qsizetype measurements()
    {
        return std::ranges::count(m_window->link().requests, modbus::Command::Measure,
                                  &link::CommandRequest::command);
    }
    double parameter(const char* name) { return m_window->panel().controller().parameter(name).lastValue(); }

private slots:
    void turnsAreTaken()
    {
        openAxis(3);
        QVERIFY(textOf("axisText").startsWith(u"Keep hands away: the film motor turns slowly"_s));
        QCOMPARE(textOf("axisPresent"), u"10,000 pulses"_s);
        tap("axisStart"); // only a held key moves the machine
        QCOMPARE(measurements(), 0);
        turn();
        QCOMPARE(measurements(), 1);
        QCOMPARE(m_window->link().requests.constLast().arguments.argument0, std::uint16_t{1});
        QCOMPARE(m_window->link().requests.constLast().arguments.argument1, modbus::measuredTurns);
        QCOMPARE(textOf("axisText"), u"Five turns, which differ by 6.5 pulses."_s);
        QCOMPARE(textOf("axisMeasured"), u"10,237 pulses"_s);
        QCOMPARE(parameter("parameter.film_pulses"), 10'000.0);
        tap("axisTake");
        QTRY_COMPARE(measurement().step(), Step::Done);
        QCOMPARE(parameter("parameter.film_pulses"), 10'237.0);
        tap("axisLeave");
        QVERIFY(m_window->find(u"axesSave"_s)->isEnabled());
    }

    void turnsAreLeft()
    {
        openAxis(5);
        turn();
        QCOMPARE(measurement().step(), Step::Result);
        QCOMPARE(propertyOf("axisLeave", "text"), u"Leave"_s);
        tap("axisLeave");
        QVERIFY(!m_window->find(u"sheetPanel"_s));
        QCOMPARE(parameter("parameter.flight_pulses"), 20'000.0);
    }

    void unevenTurnsAreNotTaken()
    {
        openAxis(3);
        modbus::MeasureStatus uneven = counted();
        uneven.spread = 60.0;
        m_window->link().setMeasure(uneven);
        turn();
        QVERIFY(textOf("axisText").startsWith(u"The turns differ by 60.0 pulses, too much."_s));
        QVERIFY(!m_window->find(u"axisTake"_s)->isEnabled());
    }

    // The gear is in the recipe.
    void mainMotorGoesIntoTheMachineData()
    {
        openMachine();
        panel::EditorField* pulses = editor().field(u"pulses_per_motor_rev"_s);
        const double before = pulses->value();
        m_window->tap(u"measureMainMotor"_s);
        turn();
        tap("axisTake");
        const double gear =
            editor().field(u"gear_numerator"_s)->value() / editor().field(u"gear_denominator"_s)->value();
        QCOMPARE(pulses->value(), std::round(10'237.4 / gear));
        QVERIFY(pulses->value() != before);
        QVERIFY(textOf("axisText").contains(u"Download the recipe to use it."_s));
    }

    void aWrongDirectionIsReversed()
    {
        openAxis(1);
        turn();
        QCOMPARE(textOf("axisText"), u"Which way did it go?"_s);
        tap("axisWrong");
        QTRY_COMPARE(measurement().step(), Step::Done);
        QCOMPARE(parameter("signal.film_reversed"), 1.0);
        turn();
        tap("axisRight");
        QCOMPARE(textOf("axisText"), u"The direction is right. Nothing was changed."_s);
        QCOMPARE(parameter("signal.film_reversed"), 1.0);
    }

    void filmPerTurnByARuler()
    {
        openAxis(4);
        QVERIFY(textOf("axisText").startsWith(u"By the present setting bag 1234 is 180.0 mm long."_s));
        tap("axisEnter");
        m_window->type(u"230"_s); // another bag
        QVERIFY(!m_window->find(u"keypadAccept"_s)->isEnabled());
        tap("keypadCancel");
        QCOMPARE(measurement().step(), Step::Ready);
        tap("axisEnter");
        m_window->type(u"176.4"_s);
        tap("keypadAccept");
        QCOMPARE(textOf("axisText"), u"The bag is 176.4 mm by the ruler and 180.0 mm by the setting."_s);
        QCOMPARE(textOf("axisMeasured"), u"147.000 mm"_s);
        tap("axisTake");
        QTRY_COMPARE(measurement().step(), Step::Done);
        QCOMPARE(parameter("parameter.film_feed"), 147.0);
    }

    void noBagIsKnown()
    {
        openMachine();
        m_window->link().setMeasure({});
        tap("openAxes");
        tap("axes4measure");
        QVERIFY(textOf("axisText").startsWith(u"The controller knows no bag yet."_s));
        QVERIFY(!m_window->find(u"axisEnter"_s)->isEnabled());
        holdFor("axisBag", 900);
        QCOMPARE(m_window->link().requests.constLast().command, modbus::Command::JogBag);
    }

    void eachEndHasItsSentence_data()
    {
        QTest::addColumn<int>("reason");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("door") << int(Refusal::DoorOpen) << u"The door is open. Close it."_s;
        QTest::newRow("Stop") << int(Refusal::None) << u"The measurement was stopped."_s;
        QTest::newRow("mark") << int(Refusal::NoIndexMark)
                              << u"No index mark came within four turns. Check the index sensor."_s;
    }
    void eachEndHasItsSentence()
    {
        QFETCH(int, reason);
        QFETCH(QString, sentence);
        openAxis(3);
        m_window->link().setMeasure(
            {.state = MeasureState::Ended, .reason = static_cast<Refusal>(reason), .bagPulses = {}});
        turn();
        QCOMPARE(textOf("axisText"), sentence + u" Nothing was changed."_s);
        QCOMPARE(parameter("parameter.film_pulses"), 10'000.0);
    }

    void aLostLineHasItsSentence()
    {
        openAxis(3);
        m_window->link().setMeasure({.state = MeasureState::Moving, .turns = 2, .bagPulses = {}});
        holdStart();
        QTRY_COMPARE(textOf("axisText"), u"Turning: 2 of 5 turns counted."_s);
        m_window->link().show(Situation::Lost);
        m_window->settle();
        QVERIFY(textOf("axisText").startsWith(u"The connection was lost during the measurement."_s));
        QCOMPARE(parameter("parameter.film_pulses"), 10'000.0);
    }

    // A running machine is not measured.
    void aRunningMachineSaysWhy()
    {
        openMachine();
        m_window->link().show(Situation::Running);
        tap("openAxes");
        tap("axes3measure");
        QVERIFY(!textOf("axisReason").isEmpty());
        holdFor("axisStart", 900);
        QCOMPARE(measurements(), 0);
    }
};

CAMPANEL_TEST(TestPanelAxes)

} // namespace test_panel_axes

#include "test_panel_axes.moc"
