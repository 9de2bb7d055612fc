// SPDX-License-Identifier: Apache-2.0
// The padlock on what the person at the panel may not do: on every page, and what a login makes of the tap.
#include "panel_test.h"
#include "tests/looks/screen_lists.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>

#include <algorithm>

namespace test_panel_padlocks {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Level;

namespace {

bool isControl(const QQuickItem& item)
{
    return item.metaObject()->indexOfProperty("waitsForLogin") >= 0 || item.inherits("QQuickSlider");
}

// Returns true for a row that its list has dropped and not yet deleted.
bool isDropped(const QQuickItem& control)
{
    const QVariant index = control.property("index");
    return index.isValid() && index.toInt() < 0;
}

// Returns the signal of a touch: a slider is dragged, and a key that commands the machine is held unless it
// is locked.
const char* signalOf(const QQuickItem& control)
{
    if (control.inherits("QQuickSlider"))
        return "moved";
    return control.property("waitsForLogin").toBool() || control.property("locked").toBool() ? "clicked"
                                                                                             : "commanded";
}

bool isReady(const QQuickItem& control)
{
    const QVariant ready = control.property("ready");
    return !ready.isValid() || ready.toBool();
}

void collect(QQuickItem& below, QList<QQuickItem*>& into)
{
    if (!below.isVisible())
        return;
    if (isControl(below) && !isDropped(below) && below.isEnabled() && below.width() > 0)
        into << &below;
    for (QQuickItem* child : below.childItems())
        collect(*child, into);
}

QString nameOfType(const QQuickItem& control)
{
    return QString::fromLatin1(control.metaObject()->className()).section(u"_QML"_s, 0, 0);
}

QString nameOf(const QQuickItem& control)
{
    return control.objectName() + u" \""_s + control.property("text").toString() + u'"';
}

// Returns the screens by the first word of their name, which is the page or the sheet.
QMap<QString, QStringList> screensByPlace()
{
    QMap<QString, QStringList> found;
    for (const looks::Screen& screen : looks::allScreens()) {
        if (!screen.name.endsWith(looks::lockedSuffix))
            found[screen.name.section(u'-', 0, 0)] << screen.name;
    }
    return found;
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
    void setLevel(Level level) { m_window->setLevel(level); }
    // Returns the controls within reach of a finger: those of the topmost layer.
    QList<QQuickItem*> controls()
    {
        QList<QQuickItem*> found;
        auto* frame = m_window->frame();
        for (const char* layer : {"login", "keypad", "sheet"}) {
            if (auto* topmost = frame->property(layer).value<QQuickItem*>()) {
                collect(*topmost, found);
                return found;
            }
        }
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
    QString placeOf(const QQuickItem& control);
    QQuickItem* nextControl();
    QString errorOf(QQuickItem& control);
    QStringList wrongOn(const QString& screen);
    QSet<QString> m_pressed; // places of controls

private slots:
    void whatAsksForALoginHasAPadlock_data()
    {
        QTest::addColumn<QStringList>("screens");
        const QMap<QString, QStringList> places = screensByPlace();
        for (auto each = places.begin(); each != places.end(); ++each)
            QTest::addRow("%s", qPrintable(each.key())) << each.value();
    }
    void whatAsksForALoginHasAPadlock()
    {
        QFETCH(QStringList, screens);
        QStringList wrong;
        for (const QString& screen : std::as_const(screens))
            wrong += wrongOn(screen);
        for (const QString& each : std::as_const(wrong))
            qInfo("%s", qPrintable(each));
        QCOMPARE(wrong.size(), 0);
        QVERIFY(!m_pressed.isEmpty());
    }

    void whoMayOnlyLookSeesPadlocks_data()
    {
        QTest::addColumn<QString>("screen");
        for (const looks::Screen& screen : looks::allScreens()) {
            if (screen.name.endsWith(looks::lockedSuffix))
                QTest::addRow("%s", qPrintable(screen.name)) << screen.name;
        }
    }
    void whoMayOnlyLookSeesPadlocks()
    {
        QFETCH(QString, screen);
        enter(screen);
        const QList<QQuickItem*> all = controls();
        QVERIFY(std::ranges::any_of(
            all, [](const QQuickItem* each) { return each->property("locked").toBool(); }));
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
        tap("curvesButton");
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
        tap("curvesButton");
        tap("field_base_speed_mm_per_s");
        tap("pinCancel");
        emit access().loginRequested(0);
        m_window->settle();
        tap("login_Li Wei");
        typePin("258036");
        QCOMPARE(access().userName(), u"Li Wei"_s);
        QVERIFY(!isOn("keypadAccept"));
    }

    // A tap asks; after the login the key is held like ever.
    void aLockedJogKeyIsPressedAgainAfterTheLogin()
    {
        enter(u"users-logged-out"_s);
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->checkClock();
        for (const char* each : {"nav_maintenance", "maintenanceMachine", "maintenanceJog"})
            m_window->tap(QString::fromLatin1(each));
        m_window->link().jogs.clear();
        tap("jogForward");
        QVERIFY(isOn("loginUsers"));
        tap("login_Li Wei");
        typePin("258036");
        QTest::qWait(5000);
        QVERIFY(!m_window->link().jogs.contains(link::JogDirection::Forward));
        tap("jogForward");
        QVERIFY2(!m_window->link().jogs.contains(link::JogDirection::Forward), "a short touch moves nothing");
        m_window->touch(u"jogForward"_s);
        QTRY_COMPARE(m_window->link().jog(), link::JogDirection::Forward);
        m_window->lift();
        m_window->settle();
        QCOMPARE(m_window->link().jog(), link::JogDirection::None);
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

// Returns where a control stands, the same for all rows of a list.
QString TestPanelPadlocks::placeOf(const QQuickItem& control)
{
    static const QRegularExpression digits(u"\\d+"_s);
    const QString name = control.objectName();
    const auto* sheet = m_window->frame()->property("sheet").value<QQuickItem*>();
    const bool isNamed = !name.isEmpty() && !name.startsWith(u"choice_");
    const QStringList parts{isNamed || !sheet ? QString() : sheet->property("title").toString(),
                            nameOfType(control), name.isEmpty() ? control.property("text").toString() : name,
                            control.property("level").toString()};
    return parts.join(u'|').remove(digits);
}

// Returns a control that was not pressed yet; null: there is none.
QQuickItem* TestPanelPadlocks::nextControl()
{
    for (QQuickItem* each : controls()) {
        const bool isLetter =
            nameOfType(*each).startsWith(u"KeypadKey") && each->property("text").toString().size() == 1;
        // Nobody cleans the screen here, and what leads to another page is a screen of its own.
        if (isLetter || each->objectName().startsWith(u"nav_") || each->objectName() == u"wipeScreen" ||
            m_pressed.contains(placeOf(*each)))
            continue;
        m_pressed << placeOf(*each);
        return each;
    }
    return nullptr;
}

// Presses a control as somebody of the level below its own, who has to be asked for that level and for no
// other. What has no level asks nobody.
QString TestPanelPadlocks::errorOf(QQuickItem& control)
{
    const QString name = nameOf(control);
    const int level = control.property("level").toInt();
    if (!isReady(control))
        return {};
    setLevel(static_cast<Level>(std::max(0, level - 1)));
    const bool isLocked = control.property("locked").toBool();
    QSignalSpy refused(&check(), &panel::AccessCheck::refused);
    QMetaObject::invokeMethod(&control, signalOf(control));
    const int needed = refused.isEmpty() ? 0 : static_cast<int>(refused.first().first().value<Level>());
    if (needed > 0)
        QMetaObject::invokeMethod(m_window->frame()->property("login").value<QObject*>(), "closed");
    return needed == level && isLocked == (level > 0)
               ? QString()
               : u"%1 has level %2, needs %3"_s.arg(name).arg(level).arg(needed);
}

// Returns the controls whose padlock says something else than what a touch does, on the screen and on what
// they open.
QStringList TestPanelPadlocks::wrongOn(const QString& screen)
{
    QStringList wrong;
    bool isNew = false; // nothing was pressed since the screen was entered
    for (;;) {
        QQuickItem* control = nextControl();
        if (!control && isNew)
            return wrong;
        if (!control) {
            setLevel(Level::Service);
            m_window->panel().audit().setWho({}); // a press may have chosen somebody
            m_window->panel().audit().setArea({});
            enter(screen);
            isNew = true;
            continue;
        }
        isNew = false;
        const QString error = errorOf(*control);
        if (!error.isEmpty())
            wrong << screen + u": "_s + error;
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

CAMPANEL_TEST(TestPanelPadlocks)

} // namespace test_panel_padlocks

#include "test_panel_padlocks.moc"
