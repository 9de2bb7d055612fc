// SPDX-License-Identifier: Apache-2.0
// The scale below a film that is drawn from left to right: ticks and numbers that rise from the right to the
// left, with the unit beside the zero.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QRectF>
#include <QString>

class QPainter;

namespace campanel::plot {

// The measures that all pictures of a film share.
namespace film {
inline constexpr double headShare = 0.6; // of a line of text: height of what stands above the film
inline constexpr double lineWidth = 2;   // px
inline constexpr double textGap = 4;     // px between two texts
inline constexpr double windowOpacity = 0.25;
} // namespace film

struct FilmScale {
    static constexpr double tickLength = 4; // px

    double width = 0;  // px, of the item
    double height = 0; // px
    double zeroX = 0;  // px, may be outside the item
    double pxPerMm = 1;
    double reachMm = 0;    // to the left of the zero
    double filmBottom = 0; // px
    QFont font;
    QString unit;
    double factor = 1; // from mm
    QLocale locale;
    QColor tickColor;
    QColor textColor;

    void paint(QPainter& painter) const;
};

// Paints the text around `x`, but within `width`. Returns its place.
QRectF paintTextWithin(QPainter& painter, double width, double x, double top, const QString& text);

} // namespace campanel::plot
