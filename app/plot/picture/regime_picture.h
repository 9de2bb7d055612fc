// SPDX-License-Identifier: Apache-2.0
// The regime map of a cutter as a picture: length across, rate up, the feasible region filled by the limit
// that ends it. Painted by Qwt with any QPainter: on the screen by RegimePlot, into a file by campanelctl.
#pragma once

#include "app/plot/picture/axis_scale.h"
#include "profile/cutter/regime_map.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QStringList>

#include <qwt_scale_div.h>
#include <qwt_scale_map.h>

#include <limits>
#include <memory>
#include <vector>

class QPainter;

namespace campanel::plot {

struct RegimeStyle {
    QColor grid{0xCF, 0xD6, 0xDC};
    QColor surface{0xFF, 0xFF, 0xFF};
    QColor inset{0xF3, 0xF5, 0xF7}; // where no rate is possible
    QColor ink{0x17, 0x21, 0x2B};
    QColor secondaryInk{0x5A, 0x68, 0x75};
    QColor dot{0x0A, 0x6C, 0x9E};
    // One for each limit, in the order of the map's; they repeat.
    QList<QColor> limits{{0x1E, 0x7B, 0x4A}, {0x0A, 0x6C, 0x9E}, {0xB2, 0x6A, 0x00},
                         {0x6B, 0x4E, 0x9B}, {0xA3, 0x3B, 0x6C}, {0x5A, 0x68, 0x75}};
    double lineWidth = 2; // px
    double dotSize = 16;  // px
    QFont font;
    QLocale locale;
};

// The contents; all texts are translated.
struct RegimeContent {
    std::shared_ptr<const profile::RegimeMap> map; // null: nothing known
    QStringList limitNames;                        // in the order of map->limits
    QString lengthUnit = QStringLiteral("mm");
    double lengthFactor = 1; // from mm
    QString rateUnit = QStringLiteral("1/min");
    QString refusedName;                                      // legend of the region without a feasible rate
    QString marksName;                                        // legend of the marks
    QList<double> marks;                                      // lengths in mm
    double shownRate = 0;                                     // a rate that the scale includes
    QPointF dot{std::numeric_limits<double>::quiet_NaN(), 0}; // length and rate of the recipe; NaN: none
};

class RegimePicture {
public:
    RegimeContent content;
    RegimeStyle style;

    // Computes the scales and the places for a picture of this size; needed before paint().
    void layOut(const QSizeF& size);
    void paint(QPainter& painter) const;

    [[nodiscard]] const QRectF& canvas() const { return m_canvas; }
    [[nodiscard]] const QwtScaleMap& lengthMap() const { return m_lengthMap; } // mm to px
    [[nodiscard]] const QwtScaleMap& rateMap() const { return m_rateMap; }     // bags/min to px

private:
    // A swatch with its name above the canvas.
    struct LegendEntry {
        QPointF place; // left and top
        QString name;
        int limit = -1; // index of the limit; -1: no rate, -2: a mark
    };
    // Neighboring points with the same limit.
    struct Band {
        int limit = 0;
        QPolygonF top; // in mm and bags/min
    };

    void layOutLegend(double width);
    void findBands();
    void paintAxes(QPainter& painter) const;
    void paintBand(QPainter& painter, const Band& band) const;
    void paintTag(QPainter& painter, const QPointF& center, int limit) const;
    void paintLines(QPainter& painter) const;
    void paintMark(QPainter& painter, const QPointF& tip) const;
    void paintLegend(QPainter& painter) const;
    void paintDot(QPainter& painter) const;
    void fill(QPainter& painter, const QPolygonF& area, int limit) const;
    [[nodiscard]] QColor colorOf(int limit) const;

    QwtScaleDiv m_lengthDivision; // exactly the range of the map
    AxisScale m_rateScale;
    QwtScaleMap m_lengthMap;
    QwtScaleMap m_rateMap;
    QRectF m_canvas;
    double m_legendHeight = 0;
    std::vector<LegendEntry> m_legend;
    std::vector<Band> m_bands;
};

} // namespace campanel::plot
