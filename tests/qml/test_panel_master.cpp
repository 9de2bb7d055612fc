// SPDX-License-Identifier: Apache-2.0
// An encoder that leads, by touch: its machine data in Settings and their padlock, the link from Maintenance,
// and the sentence of a controller without an input.
#include "panel_test.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <QAccessible>
#include <QCoreApplication>

namespace test_panel_master {

using namespace Qt::StringLiterals;
using Situation = campanel::looks::DemoLink::Situation;

class TestPanelMaster : public campanel::test::PanelTest {
    Q_OBJECT

    auto& master() { return *m_window->panel().maintenance().master(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }
    void openSettings()
    {
        tap("nav_settings");
        m_window->tapNamed(u"Machine"_s);
        m_window->tapNamed(u"Master"_s);
    }
    // Returns the row of that name, scrolled into sight; null where there is none.
    QQuickItem* rowOf(const QString& name)
    {
        QQuickItem* list = m_window->find(u"masterList"_s);
        for (int row = 0; list && row < master().fields()->rowCount(); ++row) {
            const QModelIndex index = master().fields()->index(row);
            if (master().fields()->data(index, campanel::panel::ParameterFields::NameRole) != name)
                continue;
            QMetaObject::invokeMethod(list, "positionViewAtIndex", Q_ARG(int, row), Q_ARG(int, 1));
            m_window->settle();
            return m_window->find(u"master%1"_s.arg(row));
        }
        return nullptr;
    }
    bool openKeypad(const QString& name)
    {
        if (rowOf(name))
            m_window->tapNamed(name);
        return m_window->find(u"keypadAccept"_s) != nullptr;
    }
    void choose(const QString& name, const QString& choice)
    {
        if (rowOf(name))
            m_window->tapNamed(choice);
        m_window->settle();
    }
    void enterNumber(const QString& name, const QString& digits)
    {
        if (!openKeypad(name))
            return;
        m_window->type(digits);
        tap("keypadAccept");
        m_window->settle();
    }
    QString accessibleText(const char* name, QAccessible::Text which)
    {
        QAccessibleInterface* face =
            QAccessible::queryAccessibleInterface(m_window->find(QString::fromLatin1(name)));
        return face ? face->text(which) : QString();
    }

private slots:
    void theMachineSaysWhatLeads()
    {
        enter("settings-machine");
        QCOMPARE(propertyOf("openMaster", "note"), u"Clock of the controller"_s);
        m_window->link().setLed(true);
        m_window->settle();
        QCOMPARE(plain(propertyOf("openMaster", "note")), u"Encoder · Shaft · 10,000 counts"_s);
        m_window->tapNamed(u"Master"_s);
        QCOMPARE(accessibleText("masterSetupDrawing", QAccessible::Name),
                 u"Encoder on the shaft of the line"_s);
        QCOMPARE(accessibleText("masterSetupDrawing", QAccessible::Description), u"Engaged"_s);
        QCOMPARE(textOf("masterAngle"), u"264.6°"_s);
        m_window->tapNamed(u"Machine"_s); // back
        QVERIFY(m_window->find(u"openMaster"_s));
    }

    void whatIsEnteredIsDrawnAndSaved()
    {
        enter("settings-master");
        QCOMPARE(textOf("masterCounts"), u"10,000 counts"_s);
        QVERIFY(!m_window->find(u"masterSave"_s)->isEnabled());
        enterNumber(u"Counts per revolution"_s, u"2500"_s);
        QCOMPARE(textOf("masterText"),
                 u"Counts per revolution: 2500 counts, read back from the controller."_s);
        QCOMPARE(textOf("masterCounts"), u"2500 counts"_s);
        choose(u"Place of the encoder"_s, u"Wheel"_s);
        QCOMPARE(master().fields()->value("master.place"), 1.0);
        QCOMPARE(accessibleText("masterSetupDrawing", QAccessible::Name), u"Encoder wheel on the film"_s);
        m_window->tapNamed(u"Save"_s);
        QVERIFY(!m_window->find(u"masterSave"_s)->isEnabled());
    }

    void whatCannotBeIsRefusedWithASentence()
    {
        enter("settings-master");
        QVERIFY(openKeypad(u"Counts per revolution"_s));
        m_window->type(u"3000000"_s);
        QCOMPARE(textOf("keypadHint"), u"The maximum is 1000000 counts."_s);
        QVERIFY(!m_window->find(u"keypadAccept"_s)->isEnabled());
        tap("keypadCancel");
        enterNumber(u"Counts per revolution"_s, u"1500"_s);
        enterNumber(u"Index mark: tolerance"_s, u"800"_s);
        QVERIFY2(
            textOf("masterText").endsWith(u"or more: 800 of 1500 counts. Enter a smaller tolerance first."),
            qPrintable(textOf("masterText")));
        QCOMPARE(master().fields()->value("master.index_limit"), 0.0);
    }

    void anOperatorIsAskedForALogin()
    {
        enter("users-logged-out");
        m_window->link().setLed(true);
        m_window->link().parameters.clear();
        openSettings();
        QQuickItem* row = rowOf(u"Counts per revolution"_s);
        QVERIFY(row && row->property("locked").toBool());
        choose(u"Master"_s, u"Clock"_s);
        QVERIFY(m_window->find(u"loginUsers"_s));
        tap("pinCancel");
        QCOMPARE(master().fields()->value("master.source"), 1.0);
        QVERIFY(!openKeypad(u"Counts per revolution"_s));
        tap("login_Li Wei");
        for (const char* digit : {"pin2", "pin5", "pin8", "pin0", "pin3", "pin6", "pinAccept"})
            tap(digit);
        while (m_window->panel().access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
        QVERIFY(m_window->find(u"keypadAccept"_s)); // the tap is carried out
        tap("keypadCancel");
        QVERIFY(!rowOf(u"Counts per revolution"_s)->property("locked").toBool());
    }

    void withoutAnInputBothPagesSaySo_data()
    {
        QTest::addColumn<Situation>("situation");
        QTest::addColumn<bool>("isOld");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("no controller")
            << Situation::Absent << false << u"No data of the master. Connect the controller."_s;
        QTest::newRow("an older map")
            << Situation::Running << true
            << u"This controller cannot follow an encoder. Update the controller: its register map must be 1.6 or newer."_s;
        QTest::newRow("no input")
            << Situation::Running << false
            << u"This controller has no input for an encoder. The line follows the clock of the controller."_s;
    }

    void withoutAnInputBothPagesSaySo()
    {
        QFETCH(const Situation, situation);
        QFETCH(const bool, isOld);
        QFETCH(const QString, sentence);
        enter("settings-machine");
        m_window->link().setOld(isOld);
        m_window->link().show(Situation::Absent);
        m_window->link().show(situation);
        m_window->checkClock();
        m_window->tapNamed(u"Master"_s);
        QCOMPARE(textOf("masterSetupEmpty"), sentence);
        QVERIFY(!m_window->find(u"masterList"_s) && !m_window->find(u"masterSetupDrawing"_s));
        for (const char* each : {"nav_maintenance", "maintenanceMachine", "maintenanceMaster"})
            tap(each);
        QCOMPARE(textOf("masterEmpty"), sentence);
        QVERIFY(!m_window->find(u"masterFigures"_s) && !m_window->find(u"masterSetUp"_s));
    }

    // The one page is left before or after the other is there.
    void maintenanceOpensTheSetUp()
    {
        enter("master");
        QCOMPARE(textOf("masterState"), u"Engaged"_s);
        QVERIFY(!m_window->find(u"masterList"_s));
        m_window->tapNamed(u"Set up"_s);
        QVERIFY(m_window->find(u"masterList"_s));
        QCOMPARE(accessibleText("nav_settings", QAccessible::Name), u"Settings"_s);
        QVERIFY(m_window->find(u"nav_settings"_s)->property("checked").toBool());
        QVERIFY(master().watched());
        tap("nav_maintenance");
        QVERIFY(m_window->find(u"masterFigures"_s));
        QVERIFY(master().watched());
        tap("nav_settings");
        QVERIFY(m_window->find(u"masterList"_s));
        QVERIFY(master().watched());
        m_window->tapNamed(u"Display"_s);
        QVERIFY(!master().watched());
    }
};

CAMPANEL_TEST(TestPanelMaster)

} // namespace test_panel_master

#include "test_panel_master.moc"
