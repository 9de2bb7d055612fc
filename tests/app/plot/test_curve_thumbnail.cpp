// SPDX-License-Identifier: Apache-2.0
// The ink of CurveThumbnail.
#include "samples.h"

#include "app/plot/curve_thumbnail.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace campanel::plot::test_curve_thumbnail {

namespace {
const QColor blue(0, 0, 255);
}

class TestCurveThumbnail : public QObject {
    Q_OBJECT
private slots:
    void drawsUpwardsFromTheLowerLeft()
    {
        CurveThumbnail picture;
        picture.setSize({100, 60});
        picture.setProperty("color", blue);
        picture.setPoints({{0, 0}, {0.5, 0}, {0.5, 1}, {1, 1}});
        const QImage image = test::paintItem(picture);
        QVERIFY(test::inkIn(image, {0, 50, 50, 10}, blue) > 40);
        QVERIFY(test::inkIn(image, {50, 0, 50, 10}, blue) > 40);
        QCOMPARE(test::inkIn(image, {0, 0, 45, 45}, blue), 0);
        QCOMPARE(test::inkIn(image, {55, 15, 45, 45}, blue), 0);
    }

    void drawsNothingOfOnePoint()
    {
        CurveThumbnail picture;
        picture.setSize({100, 60});
        picture.setProperty("color", blue);
        picture.setPoints({{0.5, 0.5}});
        QCOMPARE(test::inkIn(test::paintItem(picture), {0, 0, 100, 60}, blue), 0);
    }

    void reportsOnlyAChange()
    {
        CurveThumbnail picture;
        const QSignalSpy changed(&picture, &CurveThumbnail::pointsChanged);
        picture.setPoints({{0, 0}, {1, 1}});
        picture.setPoints({{0, 0}, {1, 1}});
        QCOMPARE(changed.count(), 1);
    }
};

CAMPANEL_TEST(TestCurveThumbnail)

} // namespace campanel::plot::test_curve_thumbnail

#include "test_curve_thumbnail.moc"
