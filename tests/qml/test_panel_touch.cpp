// SPDX-License-Identifier: Apache-2.0
// The calibration of the touchscreen by touch events at places of the screen, also of a wrongly wired
// touchscreen.
#include "panel_test.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"

#include <QPointingDevice>
#include <QSignalSpy>

#include <memory>

namespace test_panel_touch {

using namespace Qt::StringLiterals;
using Situation = campanel::looks::DemoLink::Situation;
using campanel::panel::TouchCalibration;

class TestPanelTouch : public campanel::test::PanelTest {
    Q_OBJECT

    std::unique_ptr<QPointingDevice> m_touchscreen{QTest::createTouchDevice()};

    TouchCalibration& calibration() { return m_window->panel().touchCalibration(); }
    void touch(const QPoint& at)
    {
        QTest::touchEvent(&m_window->window(), m_touchscreen.get()).press(0, at);
        QTest::touchEvent(&m_window->window(), m_touchscreen.get()).release(0, at);
        m_window->settle();
    }
    void openSettings()
    {
        m_window->link().show(Situation::Stopped);
        for (const char* name : {"nav_settings", "section0", "sectionSystem"})
            tap(name);
        QTRY_VERIFY(calibration().isAsked());
        m_window->settle();
        QQuickItem* view = m_window->find(u"systemScroll"_s);
        view->setProperty("contentY",
                          std::max(0.0, view->property("contentHeight").toDouble() - view->height()));
        m_window->settle();
    }
    void openCrosses()
    {
        openSettings();
        tap("setTouch");
        tap("choice_calibrate");
        QCOMPARE(calibration().crossIndex(), 0);
    }
    // Touches each cross; `reported` is where the touchscreen reports a finger at that place.
    template <typename Reported> void touchCrosses(Reported reported)
    {
        for (int i = 0; i < TouchCalibration::crosses; ++i) {
            QCOMPARE(calibration().crossIndex(), i);
            touch(reported(centerOf(u"touchCross"_s)));
        }
    }
    QByteArray request()
    {
        QFile file(QFileInfo(m_window->touchFolder()).dir().filePath(u"run/touch-request"_s));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    // Returns the largest difference of a number in the request.
    double distanceFrom(const campanel::panel::TouchMatrix& expected)
    {
        const auto matrix = campanel::panel::matrixIn(QString::fromLatin1(request().trimmed()));
        double largest = matrix ? 0 : 1;
        for (std::size_t i = 0; matrix && i < expected.size(); ++i)
            largest = std::max(largest, std::abs((*matrix)[i] - expected[i]));
        return largest;
    }
    // As campanel-touch has left it before the restart.
    void setTrial()
    {
        const QByteArray matrix = "0.000000 1.000000 0.000000 -1.000000 0.000000 1.000000";
        QVERIFY(campanel::test::writeFile(m_window->touchFolder() + u"/rule"_s,
                                          "ENV{LIBINPUT_CALIBRATION_MATRIX}=\"" + matrix + "\"\n"));
        QVERIFY(campanel::test::writeFile(m_window->touchFolder() + u"/trial"_s, "none\n" + matrix + '\n'));
        m_window->link().show(Situation::Stopped);
        calibration().resume();
        m_window->settle();
    }

private slots:
    void aRightTouchscreenStaysAsItIs()
    {
        openCrosses();
        touchCrosses([](const QPoint& at) { return at; });
        QTRY_COMPARE(m_window->unitService().m_started, QStringList{u"campanel-touch.service replace"_s});
        QVERIFY2(distanceFrom(campanel::panel::plainTouch) < 0.003, request().constData()); // whole pixels
        m_window->settle();
        QVERIFY(textOf("touchText").startsWith(u"The panel closes"_s));
    }

    void anInvertedTouchscreenIsTurnedAndStartsNothing()
    {
        openCrosses();
        const QSignalSpy sent(&m_window->panel().controller(), &campanel::panel::Controller::commandSending);
        touchCrosses([](const QPoint& at) { return QPoint(1024, 600) - at; });
        QTRY_COMPARE(m_window->unitService().m_started.size(), 1);
        QVERIFY2(distanceFrom({-1, 0, 1, 0, -1, 1}) < 0.003, request().constData());
        for (const auto& each : sent)
            QCOMPARE(each[0].value<campanel::link::CommandRequest>().command,
                     campanel::modbus::Command::StopAtCycleEnd);
    }

    void theCrossesAreThoseOfTheScreenAlsoWhenThePanelIsTurned()
    {
        m_window->panel().settings().set("display.rotation", u"180"_s);
        openCrosses();
        QVERIFY2(centerOf(u"touchCross"_s).x() > 900, "the first cross is at the lower right of the screen");
        touchCrosses([](const QPoint& at) { return at; });
        QTRY_COMPARE(m_window->unitService().m_started.size(), 1);
        QVERIFY2(distanceFrom(campanel::panel::plainTouch) < 0.003, request().constData());
    }

    void aMissedCrossIsSaidAndTriedAgain()
    {
        openCrosses();
        touchCrosses(
            [this](const QPoint& at) { return calibration().crossIndex() == 2 ? at - QPoint(150, 0) : at; });
        QCOMPARE(textOf("touchText"), u"A cross was missed. Touch the center of each cross."_s);
        QVERIFY(m_window->unitService().m_started.isEmpty());
        touch(centerOf(u"touchAgain"_s));
        QCOMPARE(calibration().crossIndex(), 0);
        touch(centerOf(u"touchCancel"_s));
        QVERIFY(!calibration().isOpen());
        QVERIFY(m_window->find(u"setTouch"_s));
    }

    void theQuestionIsAnsweredByTouch()
    {
        setTrial();
        QCOMPARE(textOf("trialKeep"), u"Keep"_s);
        touch(centerOf(u"trialKeep"_s));
        QCOMPARE(calibration().secondsLeft(), 0);
        QVERIFY(calibration().calibrated());
        QVERIFY(m_window->unitService().m_started.isEmpty());
        setTrial();
        touch(centerOf(u"trialBack"_s));
        QTRY_COMPARE(m_window->unitService().m_started.size(), 1);
        QCOMPARE(request(), QByteArray("none\n"));
    }

    void withoutTheUnitTheRowSaysWhy()
    {
        m_window->unitService().m_fileState.clear();
        openSettings();
        QVERIFY(!m_window->find(u"setTouch"_s)->isEnabled());
        QCOMPARE(textOf("screenBlocked"),
                 u"The touchscreen is calibrated in the operating system of this computer."_s);
    }
};

CAMPANEL_TEST(TestPanelTouch)

} // namespace test_panel_touch

#include "test_panel_touch.moc"
