// SPDX-License-Identifier: Apache-2.0
// The padlock on what the person at the panel may not do: on every page, and what a login makes of the tap.
#include "panel_test.h"
#include "tests/looks/screen_lists.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QPointer>
#include <QSignalSpy>

namespace test_panel_padlocks {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Level;

namespace {

bool isControl(const QQuickItem& item)
{
    return item.metaObject()->indexOfProperty("waitsForLogin") >= 0;
}

void collect(QQuickItem& below, QList<QQuickItem*>& into)
{
    if (!below.isVisible())
        return;
    if (isControl(below) && below.isEnabled() && below.width() > 0)
        into << &below;
    for (QQuickItem* child : below.childItems())
        collect(*child, into);
}

QString nameOf(const QQuickItem& control)
{
    return control.objectName() + u" \""_s + control.property("text").toString() + u'"';
}

} // namespace

class TestPanelPadlocks : public test::PanelTest {
    Q_OBJECT

    auto& access() { return m_window->panel().access(); }
    auto& check() { return m_window->panel().controller().accessCheck(); }

    void enter(const QString& name)
    {
        for (const looks::Screen& screen : looks::allScreens()) {
            if (screen.name == name)
                return looks::enterScreen(*m_window, screen);
        }
        QFAIL(qPrintable(name));
    }
    // Sets the person's level without users, whom the next screen would forget.
    void setLevel(Level level)
    {
        check().setLevel(level);
        permission()->setProperty("level", static_cast<int>(level));
        m_window->settle();
    }
    QObject* permission() { return m_window->window().property("permission").value<QObject*>(); }
    QList<QQuickItem*> controls()
    {
        QList<QQuickItem*> found;
        collect(m_window->root(), found);
        return found;
    }
    void typePin(const char* pin)
    {
        for (const char* digit = pin; *digit != '\0'; ++digit)
            tap((QByteArray("pin") + *digit).constData());
        tap("pinAccept");
        while (access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
    }
    bool isOn(const char* name) { return m_window->find(QString::fromLatin1(name)) != nullptr; }
    QStringList wrongOn(const QString& screen, Level level);
    int m_locked = 0;

private slots:
    void whatAsksForALoginHasAPadlock_data()
    {
        QTest::addColumn<QString>("screen");
        for (const char* each : {"motion", "recipes", "trends", "stops", "alarms-history", "backup",
                                 "settings-about", "settings-stops", "settings-system"})
            QTest::addRow("%s", each) << QString::fromLatin1(each);
    }
    void whatAsksForALoginHasAPadlock()
    {
        QFETCH(QString, screen);
        m_locked = 0;
        QStringList wrong = wrongOn(screen, Level::Operator);
        wrong += wrongOn(screen, Level::Viewer);
        QVERIFY(m_locked > 0);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void withoutUsersNothingHasAPadlock()
    {
        enter(u"motion"_s);
        QVERIFY(!controls().isEmpty());
        for (const QQuickItem* each : controls())
            QVERIFY2(!each->property("locked").toBool(), qPrintable(nameOf(*each)));
    }

    void aLoginCarriesOutTheTap()
    {
        enter(u"users-logged-out"_s);
        tap("nav_motion");
        QQuickItem* field = m_window->find(u"field_base_speed_mm_per_s"_s);
        QVERIFY(field);
        QVERIFY(field->property("locked").toBool());
        QVERIFY(!m_window->find(u"field_bag_length_mm"_s)->property("locked").toBool());
        tap("field_base_speed_mm_per_s");
        tap("login_Li Wei");
        typePin("258036");
        QVERIFY(isOn("keypadAccept"));
        QVERIFY(!m_window->find(u"field_base_speed_mm_per_s"_s)->property("locked").toBool());
        tap("keypadCancel");
        QVERIFY(!isOn("keypadAccept"));
    }

    // Somebody who logs in with another tap does not carry out the refused one.
    void aCanceledLoginForgetsTheTap()
    {
        enter(u"users-logged-out"_s);
        tap("nav_motion");
        tap("field_base_speed_mm_per_s");
        tap("pinCancel");
        emit access().loginRequested(0);
        m_window->settle();
        tap("login_Li Wei");
        typePin("258036");
        QCOMPARE(access().userName(), u"Li Wei"_s);
        QVERIFY(!isOn("keypadAccept"));
    }

    void theMachineDoesNotMoveBecauseSomebodyLoggedIn()
    {
        enter(u"users-logged-out"_s);
        m_window->panel().settings().overrideValue("access.operators_log_in", u"true"_s);
        m_window->panel().settings().overrideValue("access.hold_to_start", u"off"_s);
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->settle();
        QCOMPARE(access().level(), panel::Access::Viewer);
        m_window->link().requests.clear();
        tap("startKey");
        QVERIFY(isOn("loginUsers"));
        tap("login_Li Wei");
        typePin("258036");
        QTest::qWait(5000);
        QVERIFY(m_window->link().requests.isEmpty());
        tap("startKey");
        QCOMPARE(m_window->link().requests.size(), 1);
    }
};

// Returns the controls whose padlock says something else than what a touch does.
QStringList TestPanelPadlocks::wrongOn(const QString& screen, Level level)
{
    QStringList wrong;
    QSignalSpy refused(&check(), &panel::AccessCheck::refused);
    setLevel(Level::Service);
    enter(screen);
    const QVariant page = m_window->frame()->property("page");
    setLevel(level);
    QList<QPointer<QQuickItem>> all;
    for (QQuickItem* each : controls()) {
        // A key of the command column is held, and nobody cleans the screen here.
        if (each->property("waitsForLogin").toBool() && !each->objectName().startsWith(u"nav_") &&
            !each->objectName().startsWith(u"section") && each->objectName() != u"wipeScreen")
            all.prepend(each); // what leads elsewhere comes first on a page
    }
    for (const QPointer<QQuickItem>& each : std::as_const(all)) {
        if (!each || !each->isVisible() || !each->isEnabled())
            continue;
        const QString name = nameOf(*each);
        const bool isLocked = each->property("locked").toBool();
        refused.clear();
        QMetaObject::invokeMethod(each, "clicked");
        const bool asked = !refused.isEmpty();
        m_locked += isLocked ? 1 : 0;
        if (asked != isLocked)
            wrong << u"%1: %2 %3"_s.arg(screen, name, asked ? u"asks"_s : u"does not ask"_s);
        m_window->closeDialogs();
        m_window->frame()->setProperty("page", page);
        setLevel(level);
    }
    return wrong;
}

CAMPANEL_TEST(TestPanelPadlocks)

} // namespace test_panel_padlocks

#include "test_panel_padlocks.moc"
