// SPDX-License-Identifier: Apache-2.0
// The ink of CurvePlot, its mapping, and its minimum of painting.
#include "samples.h"

#include "app/plot/curve_plot.h"
#include "tests/support/test_program.h"

#include <QQuickWindow>
#include <QSignalSpy>
#include <QTest>

#include <limits>

namespace campanel::plot::test_curve_plot {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const QColor blue(0, 0, 255);
const QColor red(255, 0, 0);
const QColor green(0, 160, 0);

// Counts the paint calls of the scene graph.
class CountingPlot : public CurvePlot {
public:
    void paint(QPainter* painter) override
    {
        ++paints;
        lastClip = painter->hasClipping() ? painter->clipBoundingRect() : boundingRect();
        CurvePlot::paint(painter);
    }
    int paints = 0;
    QRectF lastClip;
};

void prepare(CurvePlot& plot)
{
    plot.setSize({600, 400});
    plot.setProperty("quantities", QStringList{QStringLiteral("velocity"), QStringLiteral("acceleration")});
    plot.setProperty("titles", QStringList{QStringLiteral("Velocity"), QStringLiteral("Acceleration")});
    plot.curveStyle()->setProperty("velocityColor", blue);
    plot.curveStyle()->setProperty("accelerationColor", green);
    plot.curveStyle()->setProperty("violationColor", red);
    plot.curveStyle()->setProperty("traceColor", QColor(Qt::magenta));
    plot.setProperty("curves", test::curveVariant([](double t) { return 300 + 100 * t; }));
}

} // namespace

class TestCurvePlot : public QObject {
    Q_OBJECT
private slots:
    void mappingIsReversible();
    void panelsAreStackedInsideTheItem();
    void inkIsWhereTheCurveIs_data();
    void inkIsWhereTheCurveIs();
    void slopesAreNotRoundedToPixels();
    void inkBeyondTheLimitHasTheViolationColor();
    void violationTintsOnlyThePanelThatBreaksTheLimit();
    void overlayCursorTraceAndMarkersAreDrawn();
    void nothingKnownDrawsAGridWithoutNumbers();
    void notANumberLeavesTheRestStanding();
    void cursorAndTraceLeaveTheImageAlone();
    void paintsOnlyWhatChanged();
    void announcesALayoutOnce();
    void timeAxisEndsWithT();
    void labelsFollowTheLocale();
};

void TestCurvePlot::mappingIsReversible()
{
    CurvePlot plot;
    prepare(plot);
    for (double t = -0.2; t <= 1.2; t += 0.05) {
        QVERIFY(std::abs(plot.timeOfX(plot.xOfTime(t)) - t) < 1e-12);
    }
    QCOMPARE(plot.xOfTime(0), plot.plotArea().left());
    QCOMPARE(plot.xOfTime(1), plot.plotArea().right());
    QVERIFY(plot.yOfVelocity(300) > plot.yOfVelocity(400));
    const QList<double> values = plot.valuesAt(0.25);
    QCOMPARE(values.size(), 2);
    QCOMPARE(values[0], 325.0);
    QCOMPARE(values[1], 2.0);
    plot.setProperty("quantities", QStringList{QStringLiteral("jerk")});
    QVERIFY(std::isnan(plot.yOfVelocity(300)));
}

void TestCurvePlot::panelsAreStackedInsideTheItem()
{
    CurvePlot plot;
    prepare(plot);
    QVERIFY(plot.panelTop(0) > 0);
    QVERIFY(plot.panelTop(1) > plot.panelTop(0) + plot.panelHeight(0));
    QCOMPARE(plot.panelHeight(0), plot.panelHeight(1));
    QVERIFY(plot.panelTop(1) + plot.panelHeight(1) < plot.height());
    QVERIFY(plot.boundingRect().contains(plot.plotArea()));
    QVERIFY(std::isnan(plot.panelTop(2)));
    QVERIFY(std::isnan(plot.panelHeight(-1)));
}

void TestCurvePlot::inkIsWhereTheCurveIs_data()
{
    QTest::addColumn<double>("pixelRatio");
    QTest::newRow("one to one") << 1.0;
    QTest::newRow("one and a half") << 1.5;
    QTest::newRow("double density") << 2.0;
}

void TestCurvePlot::inkIsWhereTheCurveIs()
{
    QFETCH(double, pixelRatio);
    CurvePlot plot;
    prepare(plot);
    const QImage image = test::paintItem(plot, pixelRatio);
    for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const double x = plot.xOfTime(t) * pixelRatio;
        const double y = plot.yOfVelocity(300 + 100 * t) * pixelRatio;
        QVERIFY2(test::inkIn(image, test::around(x, y, 1), blue) >= 5, qPrintable(QString::number(t)));
        QCOMPARE(test::inkIn(image, test::around(x, y - 20 * pixelRatio, 3), blue), 0);
        QCOMPARE(test::inkIn(image, test::around(x, y + 20 * pixelRatio, 3), blue), 0);
    }
}

void TestCurvePlot::slopesAreNotRoundedToPixels()
{
    CurvePlot plot;
    prepare(plot);
    plot.setProperty("quantities", QStringList{QStringLiteral("velocity")});
    plot.curveStyle()->setProperty("gridColor", QColor(Qt::white));
    const auto velocity = [](double t) { return t < 0.1 ? 300.0 : t > 0.9 ? 400.0 : 340 + 5 * t; };
    plot.setProperty("curves", test::curveVariant(velocity));
    const QImage image = test::paintItem(plot);
    // The center of the ink in a column of pixels, weighted by its darkness.
    for (int x = qRound(plot.xOfTime(0.2)); x < plot.xOfTime(0.8); ++x) {
        const double expected = plot.yOfVelocity(velocity(plot.timeOfX(x + 0.5)));
        double ink = 0;
        double moment = 0;
        for (int y = qRound(expected) - 8; y <= qRound(expected) + 8; ++y) {
            const double darkness = 255 - image.pixelColor(x, y).red();
            ink += darkness;
            moment += darkness * (y + 0.5);
        }
        QVERIFY2(std::abs(moment / ink - expected) < 0.2,
                 qPrintable(QString::number(moment / ink - expected)));
    }
}

void TestCurvePlot::inkBeyondTheLimitHasTheViolationColor()
{
    CurvePlot plot;
    prepare(plot);
    plot.setLimitVelocity(350);
    plot.curveStyle()->setProperty("limitColor", QColor(Qt::darkYellow));
    const QImage image = test::paintItem(plot);
    const auto inkAt = [&](double t, const QColor& color) {
        return test::inkIn(image, test::around(plot.xOfTime(t), plot.yOfVelocity(300 + 100 * t), 1), color);
    };
    QVERIFY(inkAt(0.25, blue) > 0);
    QCOMPARE(inkAt(0.25, red), 0);
    QVERIFY(inkAt(0.75, red) > 0);
    QCOMPARE(inkAt(0.75, blue), 0);
    const QRect line(QPoint(qRound(plot.xOfTime(0.05)), qRound(plot.yOfVelocity(350)) - 1), QSize(100, 3));
    QVERIFY(test::inkIn(image, line, QColor(Qt::darkYellow)) > 30);
}

void TestCurvePlot::violationTintsOnlyThePanelThatBreaksTheLimit()
{
    CurvePlot plot;
    prepare(plot);
    plot.setLimitVelocity(350);
    plot.setProperty("violations", QVariant::fromValue(QList<QPointF>{{0.5, 1.0}}));
    const QImage image = test::paintItem(plot);
    const auto colorAt = [&](double t, int panel) {
        return image.pixelColor(qRound(plot.xOfTime(t)),
                                qRound(plot.panelTop(panel) + 0.93 * plot.panelHeight(panel)));
    };
    QVERIFY(colorAt(0.8, 0).green() < 240 && colorAt(0.8, 0).red() == 255);
    QCOMPARE(colorAt(0.2, 0), QColor(Qt::white));
    QCOMPARE(colorAt(0.95, 1), QColor(Qt::white));
    // A limit without a panel is marked in all of them.
    plot.setLimitVelocity(nan);
    const QImage all = test::paintItem(plot);
    QVERIFY(all.pixelColor(qRound(plot.xOfTime(0.95)), qRound(plot.panelTop(1) + 0.93 * plot.panelHeight(1)))
                .green() < 240);
}

void TestCurvePlot::overlayCursorTraceAndMarkersAreDrawn()
{
    CurvePlot plot;
    prepare(plot);
    plot.curveStyle()->setProperty("overlayColor", QColor(Qt::cyan));
    plot.setProperty("overlayCurves", test::curveVariant([](double t) { return 390 - 80 * t; }));
    plot.curveStyle()->setProperty("inkColor", QColor(Qt::black));
    plot.curveStyle()->markerColor = red;
    plot.setProperty("markerTimes", QVariant::fromValue(QList<double>{0.25, 7.0}));
    plot.setCursorTime(0.6);
    plot.setTrace({{0.0, 370.0}, {0.2, 370.0}, {0.4, 370.0}});
    QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, test::around(plot.xOfTime(0.1), plot.yOfVelocity(382), 2), Qt::cyan) > 0);
    QVERIFY(test::inkIn(image, test::around(plot.xOfTime(0.15), plot.yOfVelocity(370), 2), Qt::magenta) > 0);
    const auto column = [&](double t) {
        return QRect(qRound(plot.xOfTime(t)) - 1, qRound(plot.panelTop(0)), 3, 300);
    };
    QVERIFY(test::inkIn(image, column(0.6), Qt::black) > 100);
    QVERIFY(test::inkIn(image, column(0.25), red) > 50);
    // The dot of the cursor is on the curve.
    QVERIFY(test::inkIn(image, test::around(plot.xOfTime(0.6), plot.yOfVelocity(360), 2), blue) > 15);
    plot.setTrace({});
    plot.setCursorTime(nan);
    image = test::paintItem(plot);
    QCOMPARE(test::inkIn(image, image.rect(), Qt::magenta), 0);
    QCOMPARE(test::inkIn(image, column(0.6), Qt::black), 0);
}

void TestCurvePlot::nothingKnownDrawsAGridWithoutNumbers()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    CurvePlot plot;
    prepare(plot);
    plot.setProperty("curves", QVariant());
    plot.setProperty("titles", QStringList());
    plot.curveStyle()->setProperty("gridColor", QColor(Qt::gray));
    plot.setCursorTime(nan);
    plot.setTrace({{0.5, nan}, {nan, 3.0}});
    const QImage image = test::paintItem(plot);
    const QRect canvas = plot.plotArea().toAlignedRect();
    QVERIFY(test::inkIn(image, canvas, Qt::gray) > canvas.width() * 4);
    int labelInk = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < canvas.left() - 1; ++x) {
            labelInk += image.pixelColor(x, y) != QColor(Qt::white) ? 1 : 0;
        }
    }
    QCOMPARE(labelInk, 0);
    QVERIFY(std::isnan(plot.valuesAt(0.5).value(0)));
    CurvePlot sizeless;
    prepare(sizeless);
    sizeless.setSize({0, 0});
    QImage nowhere(1, 1, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&nowhere);
    sizeless.paint(&painter);
    QCOMPARE(sizeless.staticPaintCount(), 0);
}

void TestCurvePlot::notANumberLeavesTheRestStanding()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    CurvePlot plot;
    prepare(plot);
    plot.setProperty("curves", test::curveVariant([](double t) { return t < 0.5 ? 300.0 + 100 * t : nan; }));
    plot.setProperty("violations", QVariant::fromValue(QList<QPointF>{{nan, nan}}));
    plot.setProperty("markerTimes", QVariant::fromValue(QList<double>{nan}));
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, test::around(plot.xOfTime(0.25), plot.yOfVelocity(325), 1), blue) >= 3);
    const QRect right(qRound(plot.xOfTime(0.55)), qRound(plot.panelTop(0)), 200, qRound(plot.panelHeight(0)));
    QCOMPARE(test::inkIn(image, right, blue), 0);
}

void TestCurvePlot::cursorAndTraceLeaveTheImageAlone()
{
    CurvePlot plot;
    prepare(plot);
    test::paintItem(plot);
    QCOMPARE(plot.staticPaintCount(), 1);
    plot.setCursorTime(0.3);
    test::paintItem(plot);
    plot.setTrace({{0.0, 320.0}, {0.1, 330.0}});
    test::paintItem(plot);
    QCOMPARE(plot.staticPaintCount(), 1);
    plot.setLimitVelocity(390);
    test::paintItem(plot);
    QCOMPARE(plot.staticPaintCount(), 2);
    plot.setLimitVelocity(390);
    plot.setLimitFrequency(nan);
    test::paintItem(plot);
    QCOMPARE(plot.staticPaintCount(), 2);
}

void TestCurvePlot::paintsOnlyWhatChanged()
{
    QQuickWindow window;
    window.resize(600, 400);
    CountingPlot plot;
    plot.setParentItem(window.contentItem());
    prepare(plot);
    window.show();
    window.grabWindow();
    QCOMPARE(plot.paints, 1);

    // The same values again: nothing to paint.
    plot.setCursorTime(nan);
    plot.setTrace({});
    plot.setLimitVelocity(nan);
    plot.setTimeMaximum(nan);
    const QVariant velocityColor = plot.curveStyle()->property("velocityColor");
    plot.curveStyle()->setProperty("velocityColor", velocityColor);
    plot.setProperty("curves", plot.property("curves"));
    window.grabWindow();
    QCOMPARE(plot.paints, 1);

    // The cursor: only a strip around its old and its new place.
    plot.setCursorTime(0.50);
    window.grabWindow();
    QCOMPARE(plot.paints, 2);
    plot.setCursorTime(0.52);
    window.grabWindow();
    QCOMPARE(plot.paints, 3);
    QVERIFY2(plot.lastClip.width() < 40, qPrintable(QString::number(plot.lastClip.width())));
    QVERIFY(plot.lastClip.contains(plot.xOfTime(0.50), plot.panelTop(0) + 10));
    QVERIFY(plot.lastClip.contains(plot.xOfTime(0.52), plot.panelTop(0) + 10));

    // A growing trace: only its end.
    plot.setTrace({{0.1, 310}, {0.2, 320}, {0.3, 330}});
    window.grabWindow();
    plot.setTrace({{0.1, 310}, {0.2, 320}, {0.3, 330}, {0.32, 332}});
    window.grabWindow();
    QCOMPARE(plot.paints, 5);
    QVERIFY2(plot.lastClip.width() < 40, qPrintable(QString::number(plot.lastClip.width())));
    QVERIFY(plot.lastClip.contains(plot.xOfTime(0.31), plot.yOfVelocity(331)));

    // Everything, then a part, in one frame: everything is painted.
    plot.setLimitVelocity(390);
    plot.setCursorTime(0.9);
    window.grabWindow();
    QCOMPARE(plot.paints, 6);
    QCOMPARE(plot.lastClip.toAlignedRect(), plot.boundingRect().toAlignedRect());
    plot.setParentItem(nullptr);
}

void TestCurvePlot::announcesALayoutOnce()
{
    QQuickWindow window;
    window.resize(600, 400);
    CurvePlot plot;
    plot.setParentItem(window.contentItem());
    QSignalSpy spy(&plot, &CurvePlot::layoutChanged);
    prepare(plot);
    window.show();
    window.grabWindow();
    QCOMPARE(spy.count(), 1);
    // A curve that fits the scale does not change the mapping.
    plot.setProperty("curves", test::curveVariant([](double t) { return 301 + 98 * t; }));
    window.grabWindow();
    QCOMPARE(spy.count(), 1);
    plot.setProperty("curves", test::curveVariant([](double t) { return 300 + 900 * t; }));
    window.grabWindow();
    QCOMPARE(spy.count(), 2);
    // Another panel makes the others lower, also at the same scale of the velocity.
    QStringList quantities{QStringLiteral("velocity")};
    for (const char* more : {"acceleration", "jerk", "frequency", "position"}) {
        const double before = plot.yOfVelocity(1000);
        const auto announced = spy.count();
        quantities << QString::fromLatin1(more);
        plot.setProperty("quantities", quantities);
        window.grabWindow();
        QCOMPARE(spy.count() > announced, plot.yOfVelocity(1000) != before);
    }
    plot.setParentItem(nullptr);
}

void TestCurvePlot::timeAxisEndsWithT()
{
    CurvePlot plot;
    prepare(plot);
    plot.setProperty("curves", test::curveVariant([](double t) { return 300 + 100 * t; }, 0.6));
    QCOMPARE(plot.timeOfX(plot.plotArea().right()), 0.6);
    plot.setTimeMaximum(0.8);
    QCOMPARE(plot.timeOfX(plot.plotArea().right()), 0.8);
    plot.setTimeMaximum(nan);
    QCOMPARE(plot.timeOfX(plot.plotArea().right()), 0.6);
}

void TestCurvePlot::labelsFollowTheLocale()
{
    CurvePlot plot;
    prepare(plot);
    plot.setProperty("timeMaximum", 0.6);
    plot.curveStyle()->setProperty("locale", QLocale(QStringLiteral("en_US")));
    const QImage english = test::paintItem(plot);
    plot.curveStyle()->setProperty("locale", QLocale(QStringLiteral("de_DE")));
    const QImage german = test::paintItem(plot);
    plot.curveStyle()->setProperty("locale", QLocale(QStringLiteral("zh_CN")));
    const QImage chinese = test::paintItem(plot);
    QVERIFY(english != german);
    QCOMPARE(chinese, english);
}

CAMPANEL_TEST(TestCurvePlot)

} // namespace campanel::plot::test_curve_plot

#include "test_curve_plot.moc"
