// SPDX-License-Identifier: Apache-2.0
// The ink of EdgePicture: places, looks that do not differ by their color alone, windows, notes.
#include "samples.h"

#include "app/plot/film/edge_picture.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace campanel::plot::test_edge_picture {

namespace {

const QColor black(0, 0, 0);
const QColor red(255, 0, 0);
const QColor blue(0, 0, 255);
enum Look { Solid, Dashed, Dotted, Rejected };

// 1000 mm of film in a picture of 800 x 160.
struct Rig {
    EdgePicture picture;

    Rig()
    {
        picture.setSize({800, 160});
        for (const char* name : {"filmColor", "edgeColor", "textColor"})
            picture.setProperty(name, QColor(Qt::white));
        picture.setProperty("markColor", black);
        picture.setProperty("windowColor", blue);
        picture.setProperty("rejectedColor", red);
        picture.setProperty("span", 1000.0);
    }
    void set(const QList<double>& places, const QList<int>& looks)
    {
        picture.setProperty("places", QVariant::fromValue(places));
        picture.setProperty("looks", QVariant::fromValue(looks));
    }
    QImage paint() { return test::paintItem(picture); }
    int inkAt(const QImage& image, double placeMm, const QColor& color, int reach = 8)
    {
        const int x = qRound(picture.xOf(placeMm));
        return test::inkIn(image, {x - reach, 0, 2 * reach + 1, image.height()}, color);
    }
};

} // namespace

class TestEdgePicture : public QObject {
    Q_OBJECT

private slots:
    void theNewestEdgeIsAtTheRight()
    {
        Rig rig;
        rig.set({-600, 0}, {Solid, Solid});
        QCOMPARE(rig.picture.xOf(0), 720.0);
        const QImage image = rig.paint();
        QVERIFY(rig.inkAt(image, 0, black) > 100);
        QVERIFY(rig.inkAt(image, -600, black) > 100);
        QCOMPARE(rig.inkAt(image, -300, black), 0);
        rig.picture.setProperty("back", 300.0);
        QVERIFY(test::inkIn(rig.paint(), {712, 0, 17, 160}, black) == 0);
        QVERIFY(test::inkIn(rig.paint(), {472, 0, 17, 160}, black) > 100);
    }

    void looksDifferByTheirShape()
    {
        Rig rig;
        rig.picture.setProperty("rejectedColor", black);
        rig.set({-600, -400, -200, 0}, {Solid, Dashed, Dotted, Rejected});
        const QImage image = rig.paint();
        const int solid = rig.inkAt(image, -600, black);
        const int dashed = rig.inkAt(image, -400, black);
        const int dotted = rig.inkAt(image, -200, black);
        const int rejected = rig.inkAt(image, 0, black);
        QVERIFY2(dashed > 30 && dashed < 0.8 * solid, qPrintable(QString::number(dashed)));
        QVERIFY2(dotted > 10 && dotted < 0.6 * dashed, qPrintable(QString::number(dotted)));
        QVERIFY2(rejected > solid + 15, qPrintable(QString::number(rejected))); // its cross
    }

    void onlyARejectedEdgeHasTheColorOfTheAbnormal()
    {
        Rig rig;
        rig.set({-600, -400, -200, 0}, {Solid, Dashed, Dotted, Rejected});
        const QImage image = rig.paint();
        for (const double placeMm : {-600.0, -400.0, -200.0})
            QCOMPARE(rig.inkAt(image, placeMm, red), 0);
        QVERIFY(rig.inkAt(image, 0, red) > 100);
        QCOMPARE(rig.inkAt(image, 0, black), 0);
    }

    void theWayFromTheWindowIsHatched()
    {
        Rig rig;
        rig.set({0}, {Rejected});
        const int alone = rig.inkAt(rig.paint(), -30, red, 12);
        rig.picture.setProperty("windows", QVariant::fromValue(QList<QPointF>{{-60, 6}}));
        const QImage image = rig.paint();
        const QColor tint(191, 191, 255);
        QVERIFY(rig.inkAt(image, -60, tint) > 200);
        QCOMPARE(rig.inkAt(image, -300, tint), 0);
        const int hatched = rig.inkAt(image, -30, red, 12);
        QVERIFY2(alone == 0 && hatched > 50, qPrintable(QString::number(hatched)));
    }

    void aNoteIsAboveItsEdge()
    {
        Rig rig;
        rig.set({-300}, {Rejected});
        const QRect above(400, 0, 160, 12);
        QCOMPARE(test::inkIn(rig.paint(), above, red), 0);
        rig.picture.setProperty("notes", QStringList{QStringLiteral("+4.3 mm")});
        QVERIFY(test::inkIn(rig.paint(), above, red) > 10);
    }

    // In a legend there is one edge without a scale.
    void aSignIsTheEdgeAlone()
    {
        Rig rig;
        rig.picture.setProperty("span", 0.0);
        rig.picture.setSize({40, 30});
        rig.set({0}, {Solid});
        QCOMPARE(rig.picture.xOf(0), 20.0);
        QVERIFY(test::inkIn(rig.paint(), {14, 0, 13, 30}, black) > 30);
    }
};

CAMPANEL_TEST(TestEdgePicture)

} // namespace campanel::plot::test_edge_picture

#include "test_edge_picture.moc"
