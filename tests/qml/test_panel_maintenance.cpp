// SPDX-License-Identifier: Apache-2.0
// The machine's sections of Service by touch: a held jog key, the events that release it, and the dial of the
// dry run.
#include "panel_test.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <QAccessible>

#include <cmath>

namespace test_panel_service {

using campanel::link::JogDirection;
using Situation = campanel::looks::DemoLink::Situation;

class TestPanelMaintenance : public campanel::test::PanelTest {
    Q_OBJECT

    auto& jog() { return *m_window->panel().maintenance().jog(); }
    auto& link() { return m_window->link(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }
    static QString accessibleName(const QQuickItem* item)
    {
        QAccessibleInterface* face = QAccessible::queryAccessibleInterface(const_cast<QQuickItem*>(item));
        return face ? face->text(QAccessible::Name) : QString();
    }
    // Returns the outputs that were asked to be on, and as -1 those to be off.
    QList<int> tried()
    {
        QList<int> outputs;
        for (const auto& request : link().requests) {
            if (request.command == campanel::modbus::Command::TryOutput)
                outputs << (request.arguments.argument1 != 0 ? request.arguments.argument0 : -1);
        }
        return outputs;
    }
    void touch(const char* name)
    {
        m_window->touch(QString::fromLatin1(name));
        m_window->settle();
    }

    // Until the ring is full.
    void press(const char* name)
    {
        touch(name);
        QTest::qWait(600);
        m_window->settle();
    }

private slots:
    void theDateCoderIsSetByFinger()
    {
        enter("io-standstill");
        tap("ioSwitches");
        tap("ioSwitch");
        const QStringList names = m_window->panel().maintenance().switches()->names();
        QCOMPARE(names.last(), QStringLiteral("Date coder pulse"));
        QQuickItem* list = m_window->find(QStringLiteral("choice_1"))->parentItem()->parentItem();
        QMetaObject::invokeMethod(list, "positionViewAtEnd");
        m_window->settle();
        m_window->tap(QStringLiteral("choice_%1").arg(names.size()));
        QCOMPARE(propertyOf("ioSwitch", "value"), names.last());
        const auto value = [this](const char* name) {
            return m_window->panel().controller().parameter(name).lastValue();
        };
        const auto set = [this](const char* row, const char* digits) {
            tap(row);
            m_window->type(QString::fromLatin1(digits));
            tap("keypadAccept");
        };
        set("camSwitch0", "-40,5");
        QCOMPARE(value("signal.coder_place"), -40.5);
        set("camSwitch1", "35");
        QCOMPARE(value("signal.coder_pulse"), 35.0);
        QCOMPARE(propertyOf("camSwitch0", "value"), QStringLiteral(u"\u221240.5"));
        // A number beyond the limits cannot be accepted, and the keypad says why.
        tap("camSwitch1");
        m_window->type(QStringLiteral("1001"));
        QVERIFY(!m_window->find(QStringLiteral("keypadAccept"))->isEnabled());
        QVERIFY(textOf("keypadHint").contains(QStringLiteral("1000")));
        QCOMPARE(value("signal.coder_pulse"), 35.0);
        tap("keypadCancel");
    }

    void theAxisIsAskedToMoveWhileTheFingerIsDown()
    {
        enter("jog");
        QCOMPARE(link().jog(), JogDirection::None);
        press("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        m_window->lift();
        QCOMPARE(link().jog(), JogDirection::None);
        press("jogReverse");
        QCOMPARE(link().jog(), JogDirection::Reverse);
        m_window->lift();
        QCOMPARE(link().jog(), JogDirection::None);
    }

    void slidingOffEndsItAndSlidingBackDoesNotBegin()
    {
        enter("jog");
        const QPointF on = centerOf(QStringLiteral("jogForward"));
        press("jogForward");
        m_window->slide(on - QPointF(0, 400));
        QCOMPARE(link().jog(), JogDirection::None);
        m_window->slide(on);
        QCOMPARE(link().jog(), JogDirection::None);
        m_window->lift();
    }

    void whatTakesTheKeysAwayLetsGo_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("another page") << 0;
        QTest::newRow("another section") << 1;
        QTest::newRow("a sheet") << 2;
        QTest::newRow("the login") << 3;
        QTest::newRow("Stop") << 4;
    }

    void whatTakesTheKeysAwayLetsGo()
    {
        QFETCH(const int, what);
        enter("jog");
        press("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        if (what == 0)
            QMetaObject::invokeMethod(m_window->frame(), "openPage", Q_ARG(QString, QStringLiteral("run")));
        else if (what == 1)
            QMetaObject::invokeMethod(m_window->find(QStringLiteral("maintenanceHoming")), "clicked");
        else if (what == 2)
            QMetaObject::invokeMethod(m_window->find(QStringLiteral("jogSpeed")), "clicked");
        else if (what == 3)
            emit m_window->panel().access().loginRequested(campanel::panel::Access::Technician);
        else
            m_window->panel().controller().stop();
        m_window->settle();
        QCOMPARE(link().jog(), JogDirection::None);
        QCOMPARE(jog().held(), 0);
        m_window->lift();
        m_window->closeDialogs();
    }

    void windowThatIsNotInFrontLetsGo()
    {
        enter("jog");
        m_window->window().show();
        m_window->window().requestActivate();
        QVERIFY(QTest::qWaitForWindowActive(&m_window->window()));
        press("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        QQuickWindow other;
        other.show();
        other.requestActivate();
        QTRY_COMPARE(link().jog(), JogDirection::None);
        m_window->lift();
    }

    void aRunningMachineDoesNotJogAndThePageSaysWhy()
    {
        enter("jog-blocked");
        press("jogForward");
        m_window->lift();
        QCOMPARE(link().jog(), JogDirection::None);
        QCOMPARE(textOf("jogText"), QStringLiteral("The machine is running. Stop it first."));
    }

    void anOutputIsTriedWhileTheFingerIsDown()
    {
        enter("io-standstill");
        const QQuickItem* key = m_window->find(QStringLiteral("try2"));
        QVERIFY(key && key->isVisible());
        QCOMPARE(accessibleName(key), QStringLiteral("Try Cam switch 3"));
        link().requests.clear();
        press("try2");
        QCOMPARE(tried(), QList{2});
        QCOMPARE(textOf("ioText"), QStringLiteral("Cam switch 3 is on while you hold the key."));
        m_window->lift();
        QCOMPARE(tried().last(), -1);
        const QPointF on = centerOf(QStringLiteral("try2"));
        press("try2");
        QCOMPARE(tried().last(), 2);
        m_window->slide(on - QPointF(300, 0));
        QCOMPARE(tried().last(), -1);
        const qsizetype before = tried().size();
        m_window->slide(on);
        m_window->lift();
        QCOMPARE(tried().size(), before);
    }

    void whatTakesTheKeysAwaySwitchesTheOutputOff_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("another page") << 0;
        QTest::newRow("another section") << 1;
        QTest::newRow("the parameters") << 2;
        QTest::newRow("the login") << 3;
    }

    void whatTakesTheKeysAwaySwitchesTheOutputOff()
    {
        QFETCH(const int, what);
        enter("io-standstill");
        link().requests.clear();
        press("try2");
        QCOMPARE(tried(), QList{2});
        if (what == 0)
            QMetaObject::invokeMethod(m_window->frame(), "openPage", Q_ARG(QString, QStringLiteral("run")));
        else if (what == 1)
            QMetaObject::invokeMethod(m_window->find(QStringLiteral("maintenanceHoming")), "clicked");
        else if (what == 2)
            QMetaObject::invokeMethod(m_window->find(QStringLiteral("ioSwitches")), "clicked");
        else
            emit m_window->panel().access().loginRequested(campanel::panel::Access::Technician);
        m_window->settle();
        QCOMPARE(m_window->panel().maintenance().outputTry()->held(), -1);
        QCOMPARE(tried().last(), -1);
        m_window->lift();
        m_window->closeDialogs();
    }

    void aRunningMachineTriesNothingAndThePageSaysWhy()
    {
        enter("io");
        link().requests.clear();
        press("try2");
        QCOMPARE(tried(), QList<int>());
        QCOMPARE(textOf("ioText"), QStringLiteral("The machine is running. Stop it first."));
        m_window->lift();
    }

    void theDialIsTurned()
    {
        enter("dry-run");
        auto& run = *m_window->panel().maintenance().dryRun();
        tap("dryRunStart");
        QCOMPARE(run.masterDeg(), 0.0);
        tap("dryRunOn");
        tap("dryRunOn");
        tap("dryRunBack");
        QVERIFY(std::abs(run.masterDeg() - 1) < 1e-9);
        QQuickItem* dial = m_window->find(QStringLiteral("dryRunDial"));
        QVERIFY(dial);
        const QPointF center = dial->mapToScene(dial->boundingRect().center());
        const double radius = dial->width() / 3;
        touch("dryRunDial"); // its center, or any place
        m_window->slide(center + QPointF(0, -radius));
        const double before = run.masterDeg();
        m_window->slide(center + QPointF(radius, 0));
        QVERIFY(std::abs(std::remainder(run.masterDeg() - before - 90, 360)) < 1.0);
        m_window->lift();
        tap("dryRunPlay");
        QVERIFY(run.playing());
        tap("nav_run");
        QVERIFY(!run.playing());
    }
};

CAMPANEL_TEST(TestPanelMaintenance)

} // namespace test_panel_service

#include "test_panel_maintenance.moc"
