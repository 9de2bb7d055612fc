// SPDX-License-Identifier: Apache-2.0
// The ink of BandPlot: the band where it is learned, readings, the jam as a cross, the lines of the cut and
// of the closing jaws.
#include "samples.h"

#include "app/plot/band_plot.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace campanel::plot::test_band_plot {

namespace {

const QColor black(0, 0, 0);
const QColor red(255, 0, 0);
const QColor blue(0, 0, 255);
const QColor green(0, 255, 0);

struct Rig {
    BandPlot plot;

    Rig()
    {
        plot.setSize({640, 300});
        for (const char* name : {"gridColor", "secondaryInkColor", "expectedColor"})
            plot.setProperty(name, QColor(Qt::white));
        plot.setProperty("bandColor", blue);
        plot.setProperty("readingColor", green);
        plot.setProperty("jamColor", red);
        plot.setProperty("from", -40.0);
        plot.setProperty("to", 40.0);
    }
    // Four parts of 20 degrees; the second one is not learned.
    void learn()
    {
        plot.setProperty("expected", QVariant::fromValue(QList<QPointF>{{-30, 10}, {10, 30}, {30, 20}}));
        plot.setProperty("halfWidths", QVariant::fromValue(QList<double>{5, 10, 5}));
    }
    QImage paint() { return test::paintItem(plot); }
    int inkAt(const QImage& image, double deg, double torque, const QColor& color)
    {
        const int x = qRound(plot.xOfAngle(deg));
        const int y = qRound(plot.yOfTorque(torque));
        return test::inkIn(image, {x - 4, y - 4, 9, 9}, color);
    }
};

} // namespace

class TestBandPlot : public QObject {
    Q_OBJECT

private slots:
    void theBandIsWhereItIsLearned()
    {
        Rig rig;
        QCOMPARE(test::inkIn(rig.paint(), {0, 0, 640, 300}, blue), 0);
        rig.learn();
        const QImage image = rig.paint();
        QVERIFY(rig.inkAt(image, -30, 13, blue) > 70);
        QVERIFY(rig.inkAt(image, -21, 7, blue) > 40); // to the end of its part
        QCOMPARE(rig.inkAt(image, -30, 22, blue), 0);
        QCOMPARE(rig.inkAt(image, -10, 20, blue), 0);
        QVERIFY(rig.inkAt(image, 10, 37, blue) > 70);
        QVERIFY(rig.inkAt(image, 30, 17, blue) > 70);
    }

    void theExpectedTorqueIsALine()
    {
        Rig rig;
        rig.learn();
        rig.plot.setProperty("expectedColor", black);
        const QImage image = rig.paint();
        QVERIFY(rig.inkAt(image, -30, 10, black) >= 18);
        QCOMPARE(rig.inkAt(image, -10, 20, black), 0);
    }

    void theNewestReadingIsTheLargest()
    {
        Rig rig;
        rig.plot.setProperty("readings", QVariant::fromValue(QList<QPointF>{{-20, 5}, {20, 8}}));
        const QImage image = rig.paint();
        const int earlier = rig.inkAt(image, -20, 5, green);
        const int newest = rig.inkAt(image, 20, 8, green);
        QVERIFY2(earlier > 3 && newest > 2 * earlier, qPrintable(QString::number(newest)));
    }

    void aJamIsACrossAndInSight()
    {
        Rig rig;
        rig.learn();
        QCOMPARE(test::inkIn(rig.paint(), {0, 0, 640, 300}, red), 0);
        rig.plot.setProperty("jam", QPointF(-15, 90)); // far beyond the band
        const QImage image = rig.paint();
        const int cross = rig.inkAt(image, -15, 90, red);
        QVERIFY2(cross > 15 && cross < 60, qPrintable(QString::number(cross)));
    }

    void cutAndClosingAreNamed()
    {
        Rig rig;
        rig.plot.setProperty("secondaryInkColor", black);
        rig.paint();
        const auto above = [&](double deg) {
            return test::inkIn(rig.paint(), {qRound(rig.plot.xOfAngle(deg)) - 20, 0, 40, 14}, black);
        };
        QCOMPARE(above(-25), 0);
        rig.plot.setProperty("closing", -25.0);
        rig.plot.setProperty("closingLabel", QStringLiteral("closes"));
        rig.plot.setProperty("cutLabel", QStringLiteral("the cut"));
        QVERIFY(above(-25) > 10);
        QVERIFY(above(0) > 10);
    }
};

CAMPANEL_TEST(TestBandPlot)

} // namespace campanel::plot::test_band_plot

#include "test_band_plot.moc"
