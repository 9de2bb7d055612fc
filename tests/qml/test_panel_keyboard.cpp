// SPDX-License-Identifier: Apache-2.0
// A keyboard at the panel, and a scanner without a prefix, which is one: what the focus reaches, what a key
// presses, and what a person sees of it.
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_keyboard {

using namespace campanel;
using namespace Qt::StringLiterals;
using Situation = looks::DemoLink::Situation;

class TestPanelKeyboard : public test::PanelTest {
    Q_OBJECT

    auto& link() { return m_window->link(); }
    void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        link().advance(std::chrono::milliseconds(200)); // by hand
        QTest::keyClick(&m_window->window(), static_cast<Qt::Key>(key), modifiers);
        m_window->settle();
    }
    // The keys of a scanner: all at once.
    void scan(const QString& code)
    {
        for (const QChar key : code + u'\r')
            QTest::sendKeyEvent(QTest::Click, &m_window->window(),
                                key == u'\r' ? Qt::Key_Return : QTest::asciiToKey(key.toLatin1()),
                                QString(key), key.isUpper() ? Qt::ShiftModifier : Qt::NoModifier);
        m_window->settle();
    }
    QString focused()
    {
        const QQuickItem* item = m_window->window().activeFocusItem();
        return item ? item->objectName() : QString();
    }
    bool tabTo(const QString& name)
    {
        for (int i = 0; i < 100 && focused() != name; ++i)
            key(Qt::Key_Tab);
        return focused() == name;
    }
    QString page() { return m_window->frame()->property("page").toString(); }
    bool isRingVisible() { return m_window->find(u"focusRing"_s) != nullptr; }

private slots:
    void noKeyCommandsTheMachine_data()
    {
        QTest::addColumn<Situation>("situation");
        QTest::addColumn<QStringList>("way");
        const QStringList machine{u"nav_maintenance"_s, u"maintenanceMachine"_s};
        QTest::newRow("Run") << Situation::Fresh << QStringList{u"nav_run"_s};
        QTest::newRow("fault") << Situation::Fault << QStringList{u"nav_run"_s};
        QTest::newRow("jog") << Situation::Stopped << machine + QStringList{u"maintenanceJog"_s};
        QTest::newRow("reference run") << Situation::Stopped << machine + QStringList{u"maintenanceHoming"_s};
        QTest::newRow("outputs") << Situation::Stopped << machine + QStringList{u"maintenanceIo"_s};
    }

    void noKeyCommandsTheMachine()
    {
        QFETCH(const Situation, situation);
        QFETCH(const QStringList, way);
        m_window->panel().settings().set("access.hold_to_start", u"off"_s);
        link().show(situation);
        m_window->checkClock();
        m_window->settle();
        for (const QString& name : way)
            m_window->tap(name);
        link().requests.clear();
        link().jogs.clear();
        const QSet<QString> commands{u"startKey"_s,   u"middleKey"_s, u"stopKey"_s, u"jogForward"_s,
                                     u"jogReverse"_s, u"homingKey"_s, u"try0"_s,    u"try2"_s};
        QSet<QString> reached;
        for (int i = 0; i < 60; ++i) {
            key(Qt::Key_Backtab, Qt::ShiftModifier);
            if (commands.contains(focused())) {
                reached << focused();
                key(Qt::Key_Space);
                key(Qt::Key_Return);
            }
        }
        QCOMPARE(link().requests.size(), 0);
        QVERIFY(link().jogs.isEmpty());
        QCOMPARE(reached, QSet<QString>());
    }

    void theFocusIsSeenFromTheFirstTabToTheNextTouch()
    {
        tap("nav_run");
        QVERIFY(!isRingVisible());
        QVERIFY(tabTo(u"nav_recipes"_s));
        QVERIFY(isRingVisible());
        QTest::qWait(100); // a frame
        const QQuickItem* ring = m_window->find(u"focusRing"_s)->childItems().constFirst();
        const QRectF place = ring->mapRectToScene(ring->boundingRect());
        QVERIFY(place.contains(centerOf(u"nav_recipes"_s)));
        tap("nav_motion");
        QVERIFY(!isRingVisible());
        key(Qt::Key_Space); // presses nothing that is not seen
        QCOMPARE(page(), u"motion"_s);
    }

    void enterPressesAsSpaceDoes_data()
    {
        QTest::addColumn<int>("pressed");
        QTest::newRow("Space") << int(Qt::Key_Space);
        QTest::newRow("Return") << int(Qt::Key_Return);
        QTest::newRow("Enter") << int(Qt::Key_Enter);
    }

    void enterPressesAsSpaceDoes()
    {
        QFETCH(const int, pressed);
        tap("nav_run");
        QVERIFY(tabTo(u"nav_recipes"_s));
        key(pressed);
        QCOMPARE(page(), u"recipes"_s);
    }

    void aScannerWithoutPrefixPressesNothing_data()
    {
        QTest::addColumn<bool>("byTab");
        QTest::newRow("after a touch") << false;
        QTest::newRow("after Tab") << true;
    }

    void aScannerWithoutPrefixPressesNothing()
    {
        QFETCH(const bool, byTab);
        link().show(Situation::Stopped);
        m_window->checkClock();
        m_window->settle();
        tap("nav_recipes");
        if (byTab)
            QVERIFY(tabTo(u"nav_recipes"_s));
        QMetaObject::invokeMethod(m_window->frame(), "openPage", Q_ARG(QString, u"run"_s));
        link().requests.clear();
        scan(u"Biscuit 250 6 x 4"_s);
        QTest::qWait(5000);
        QCOMPARE(page(), u"run"_s);
        QVERIFY(!m_window->find(u"sheetPanel"_s));
        QCOMPARE(link().requests.size(), 0);
        if (byTab) {
            key(Qt::Key_Space); // a hand
            QCOMPARE(page(), u"recipes"_s);
        }
    }

    void theFocusStaysInTheSheet()
    {
        tap("nav_motion");
        tap("more");
        for (int i = 0; i < 30; ++i) {
            key(Qt::Key_Tab);
            const QQuickItem* item = m_window->window().activeFocusItem();
            while (item && item->objectName() != u"overlay"_s)
                item = item->parentItem();
            QVERIFY2(item, qPrintable(focused()));
        }
        m_window->closeDialogs();
    }
};

CAMPANEL_TEST(TestPanelKeyboard)

} // namespace test_panel_keyboard

#include "test_panel_keyboard.moc"
