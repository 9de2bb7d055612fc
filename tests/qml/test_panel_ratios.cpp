// SPDX-License-Identifier: Apache-2.0
// The ratios by touch: keys, slider, window, and the longer ramps that the verdict offers.
#include "tests/qml/panel_test.h"

#include "tests/support/test_program.h"

#include <cmath>

namespace test_panel_ratios {

using namespace campanel;
using namespace Qt::StringLiterals;
using profile::RatioMode;

class TestPanelRatios : public test::PanelTest {
    Q_OBJECT

    RatioMode mode() { return editor().recipe().cutter().ratioMode; }
    void openRatios()
    {
        tap("nav_motion");
        tap("ratios");
        QVERIFY(m_window->find(u"ratioSheet"_s));
    }

private slots:
    void keysSetTheRatiosAndTheCurveStaysVisible()
    {
        openRatios();
        QCOMPARE(mode(), RatioMode::ByHand);
        tap("ratioGentle");
        QCOMPARE(mode(), RatioMode::Gentle);
        tap("ratioCool");
        QCOMPARE(mode(), RatioMode::Cool);
        tap("ratioSlow");
        QCOMPARE(mode(), RatioMode::Slow);
        // The sheet lies beside the curve.
        const QQuickItem* panel = m_window->find(u"sheetPanel"_s);
        const QQuickItem* plot = m_window->find(u"motionPlot"_s);
        QVERIFY(panel && plot);
        QVERIFY(panel->mapToScene(QPointF(panel->width(), 0)).x() <= plot->mapToScene(QPointF()).x());
        tap("sheetClose");
        QCOMPARE(textOf("ratioOrigin"), u"Ratios: slow"_s);
        tap("undo");
        tap("undo");
        tap("undo");
        QCOMPARE(textOf("ratioOrigin"), u"Ratios: set by hand"_s);
    }

    void theSliderMovesTheRamps()
    {
        editor().rate()->set(200);
        openRatios();
        tap("ratioGentle");
        const double gentle = editor().recipe().cutter().k[0];
        const QQuickItem* slider = m_window->find(u"ratioSlider"_s);
        QVERIFY(slider);
        const double left = slider->mapToScene(QPointF()).x();
        const double y = centerOf(u"ratioSlider"_s).y();
        m_window->touch(u"ratioSlider"_s);
        m_window->slide({left + 0.75 * slider->width(), y});
        QCOMPARE(mode(), RatioMode::Between);
        const double between = editor().recipe().cutter().k[0];
        QVERIFY(between < gentle);
        m_window->slide({left + 0.1 * slider->width(), y});
        QVERIFY(editor().recipe().cutter().k[0] < between);
        m_window->lift();
        QVERIFY(std::abs(slider->property("value").toDouble() - editor().ramps()->position()) < 1);
        editor().undo();
        QCOMPARE(mode(), RatioMode::Gentle);
    }

    void aNumberByHandIsKeptUntilAKeyReturns()
    {
        openRatios();
        tap("ratioGentle");
        tap("ratioNumbers"); // the keypad
        m_window->type(u"1.5"_s);
        tap("keypadAccept");
        QCOMPARE(mode(), RatioMode::ByHand);
        tap("ratioGentle");
        QCOMPARE(mode(), RatioMode::Gentle);
    }

    void theWindowHasItsKeys()
    {
        openRatios();
        tap("ratioGentle");
        tap("windowWider");
        QCOMPARE(textOf("windowText"), u"21.0 %"_s);
        tap("windowNarrower");
        tap("windowNarrower");
        QCOMPARE(textOf("windowText"), u"19.0 %"_s);
        QCOMPARE(mode(), RatioMode::Gentle);
    }

    void figuresExplainThemselves()
    {
        openRatios();
        m_window->hold(u"ratioFigures"_s);
        QVERIFY(m_window->find(u"explanationText"_s));
    }

    void longerRampsAreOneTap()
    {
        editor().bagLength()->set(150);
        editor().rate()->set(260);
        tap("nav_motion");
        QVERIFY(!editor().feasible());
        QCOMPARE(textOf("rampOffer"), u"Longer ramps"_s);
        tap("rampOffer");
        QVERIFY(editor().feasible());
        QCOMPARE(editor().rate()->value(), 260.0);
        QVERIFY(!m_window->find(u"rampOffer"_s));
        QCOMPARE(textOf("ratioOrigin"), u"Ratios: gentle"_s);
    }
};

CAMPANEL_TEST(TestPanelRatios)

} // namespace test_panel_ratios

#include "test_panel_ratios.moc"
