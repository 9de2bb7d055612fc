// SPDX-License-Identifier: Apache-2.0
// The ink of StripChart: the worst of the minutes that share a column, the newest on the right.
#include "app/plot/strip_chart.h"
#include "tests/support/test_program.h"

#include <QPainter>
#include <QTest>

#include <cmath>
#include <limits>

namespace test_strip_chart {

using namespace campanel;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const QColor red(255, 0, 0);

QRect inkOf(const QImage& image, const QColor& color)
{
    QRect ink;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y) == color)
                ink |= QRect(x, y, 1, 1);
        }
    }
    return ink;
}

} // namespace

class TestStripChart : public QObject {
    Q_OBJECT

private slots:
    void columnsShowTheWorst()
    {
        const QList<double> worst = plot::worstOfColumns({1, 5, unknown, 2, 3, unknown}, 6, 3);
        QCOMPARE(worst, (QList<double>{5, 2, 3}));
        // A short record is on the right.
        const QList<double> brief = plot::worstOfColumns({7}, 6, 3);
        QVERIFY(std::isnan(brief[0]) && std::isnan(brief[1]));
        QCOMPARE(brief[2], 7.0);
        // The newest values of a long record.
        QCOMPARE(plot::worstOfColumns({9, 9, 1, 2}, 2, 2), (QList<double>{1, 2}));
    }

    void oneBadMinuteIsSeen()
    {
        plot::StripChart chart;
        chart.setSize({720, 200});
        QList<double> errors(plot::StripChart::minutes, 0.0);
        errors[plot::StripChart::minutes / 2] = 1;
        chart.setProperty("errors", QVariant::fromValue(errors));
        chart.setProperty("errorsColor", red);
        QImage image(720, 200, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        chart.paint(&painter);
        painter.end();
        const QRect ink = inkOf(image, red);
        QVERIFY(!ink.isEmpty());
        QVERIFY2(std::abs(ink.center().x() - 360) <= 3, qPrintable(QString::number(ink.center().x())));
        QVERIFY(ink.top() > 100 && ink.height() > 10);
    }

    void nothingIsKnown()
    {
        plot::StripChart chart;
        chart.setSize({720, 200});
        chart.setProperty("errorsColor", red);
        QImage image(720, 200, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        chart.paint(&painter);
        painter.end();
        QVERIFY(inkOf(image, red).isEmpty());
    }
};

CAMPANEL_TEST(TestStripChart)

} // namespace test_strip_chart

#include "test_strip_chart.moc"
