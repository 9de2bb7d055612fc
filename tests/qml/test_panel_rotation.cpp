// SPDX-License-Identifier: Apache-2.0
// The panel on a screen that is mounted upside down or upright, by touch on the turned screen.
#include "panel_test.h"
#include "tests/support/test_program.h"

#include <QPointingDevice>
#include <QSignalSpy>

#include <memory>

namespace test_panel_rotation {

using namespace Qt::StringLiterals;
using Situation = campanel::looks::DemoLink::Situation;

class TestPanelRotation : public campanel::test::PanelTest {
    Q_OBJECT

    std::unique_ptr<QPointingDevice> m_touchscreen{QTest::createTouchDevice()};

    campanel::panel::ScreenRotation& rotation() { return m_window->panel().rotation(); }
    // Touches a place of the window, px, as the screen has it.
    void touch(const QPoint& at)
    {
        QTest::touchEvent(&m_window->window(), m_touchscreen.get()).press(0, at);
        QTest::touchEvent(&m_window->window(), m_touchscreen.get()).release(0, at);
        m_window->settle();
    }
    void tryUpsideDown()
    {
        m_window->link().show(Situation::Stopped);
        for (const char* name : {"nav_settings", "section0", "sectionSystem", "setRotation", "choice_180"})
            tap(name);
        QCOMPARE(rotation().secondsLeft(), campanel::panel::ScreenRotation::trialTimeS);
    }
    [[nodiscard]] QSizeF sizeOfPanel() { return m_window->theme()->property("window").toSizeF(); }

private slots:
    void touchesFollowThePanel()
    {
        const QPoint stop = centerOf(u"stopKey"_s);
        tryUpsideDown();
        QCOMPARE(centerOf(u"stopKey"_s), QPoint(1024, 600) - stop);
        touch(centerOf(u"trialKeep"_s));
        QCOMPARE(rotation().secondsLeft(), 0);
        QCOMPARE(m_window->panel().settings().values().whole("display.rotation"), 180);
        touch(centerOf(u"nav_run"_s));
        QCOMPARE(m_window->frame()->property("page").toString(), u"run"_s);
        const QPoint settings = centerOf(u"nav_settings"_s);
        QVERIFY2(settings.x() > 900 && settings.y() < 300, "the navigation is at the other side");
        touch(settings);
        QCOMPARE(m_window->frame()->property("page").toString(), u"settings"_s);
    }

    void stopActsAndStartDoesNotDuringTheQuestion()
    {
        tryUpsideDown();
        const QSignalSpy sent(&m_window->panel().controller(), &campanel::panel::Controller::commandSending);
        touch(centerOf(u"startKey"_s));
        QCOMPARE(sent.size(), 0);
        touch(centerOf(u"stopKey"_s));
        QCOMPARE(sent.size(), 1);
        touch(centerOf(u"trialBack"_s));
        touch(centerOf(u"startKey"_s));
        QCOMPARE(sent.size(), 2);
    }

    void withoutAnAnswerThePanelTurnsBack()
    {
        const QPoint stop = centerOf(u"stopKey"_s);
        tryUpsideDown();
        for (int second = 0; second < campanel::panel::ScreenRotation::trialTimeS; ++second)
            rotation().tick();
        m_window->settle();
        QCOMPARE(centerOf(u"stopKey"_s), stop);
        QVERIFY(!m_window->find(u"trialKeep"_s));
        QVERIFY(m_window->find(u"setRotation"_s));
    }

    void theKeyGoesBackAtOnce()
    {
        tryUpsideDown();
        touch(centerOf(u"trialBack"_s));
        QCOMPARE(rotation().degrees(), 0);
        QCOMPARE(m_window->panel().settings().values().whole("display.rotation"), 0);
    }

    void anUprightScreenGetsTheWidePanel()
    {
        m_window->window().resize(600, 1024);
        QTRY_COMPARE(sizeOfPanel(), QSizeF(1024, 600));
        m_window->settle();
        QCOMPARE(rotation().degrees(), 90);
        // A quarter turn clockwise: Stop, at the lower right of the panel, is at the lower left of the
        // screen.
        const QPoint stop = centerOf(u"stopKey"_s);
        QVERIFY2(stop.x() < 300 && stop.y() > 900, qPrintable(u"%1, %2"_s.arg(stop.x()).arg(stop.y())));
        touch(centerOf(u"nav_motion"_s));
        QCOMPARE(m_window->frame()->property("page").toString(), u"motion"_s);
    }

    // A person may make a window of a desktop as narrow as the window system lets them.
    void aWindowOfADesktopDoesNotLieOnItsSide()
    {
        QWindow& window = m_window->window();
        QVERIFY(window.setProperty("hasWindowSystem", true));
        QCOMPARE(window.minimumSize(), QSize(800, 480));
        window.resize(820, 1100);
        QTRY_COMPARE(sizeOfPanel(), QSizeF(820, 1100));
        m_window->settle();
        QCOMPARE(rotation().degrees(), 0);
        touch(centerOf(u"nav_motion"_s));
        QCOMPARE(m_window->frame()->property("page").toString(), u"motion"_s);
    }

    void thePictureOfTheServiceBundleIsUpright()
    {
        const QImage before = m_window->grab();
        m_window->panel().settings().set("display.rotation", u"180"_s);
        m_window->settle();
        const QImage turned = m_window->grab();
        QVERIFY(turned != before);
        QCOMPARE(m_window->panel().picture(), turned.transformed(QTransform().rotate(180)));
    }
};

CAMPANEL_TEST(TestPanelRotation)

} // namespace test_panel_rotation

#include "test_panel_rotation.moc"
