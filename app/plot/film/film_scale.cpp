// SPDX-License-Identifier: Apache-2.0
#include "app/plot/film/film_scale.h"

#include "app/plot/picture/label_draw.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double numberSpacing = 64; // px, minimum between two numbers

// Returns the smallest of 1, 2, 5, 10, 20 ... that leaves space for the numbers.
double tickStep(double pxPerUnit)
{
    double decade = 1;
    while (true) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * decade * pxPerUnit >= numberSpacing)
                return factor * decade;
        }
        decade *= 10;
    }
}

} // namespace

void FilmScale::paint(QPainter& painter) const
{
    const double step = tickStep(pxPerMm / factor);
    const double stepMm = step / factor;
    const QFontMetricsF metrics(font);
    const double textTop = height - metrics.height();
    double freeUpTo = width;
    const int first = std::max(0, static_cast<int>(std::floor((zeroX - width) / (stepMm * pxPerMm))));
    for (int i = first; i * stepMm <= reachMm; ++i) {
        const double x = zeroX - i * stepMm * pxPerMm;
        if (x < 0)
            break;
        painter.setPen(QPen(tickColor, 1));
        painter.drawLine(QPointF(x, filmBottom), QPointF(x, filmBottom + tickLength));
        const QString number = localNumber(locale, i * step, 0);
        const QString text = i == 0 ? number + u' ' + unit : number;
        const double half = metrics.horizontalAdvance(text) / 2;
        if (x - half < 0 || x + half > freeUpTo - film::textGap)
            continue;
        painter.setPen(textColor);
        freeUpTo = paintTextWithin(painter, width, x, textTop, text).left();
    }
}

QRectF paintTextWithin(QPainter& painter, double width, double x, double top, const QString& text)
{
    const QFontMetricsF metrics(painter.font());
    const double textWidth = metrics.horizontalAdvance(text);
    const double left = std::clamp(x - textWidth / 2, 0.0, std::max(0.0, width - textWidth));
    painter.drawText(QPointF(left, top + metrics.ascent()), text);
    return {left, top, textWidth, metrics.height()};
}

} // namespace campanel::plot
