// SPDX-License-Identifier: Apache-2.0
// How a curve plot looks, as plain values: what the painting code needs to know of the item's properties.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>

namespace campanel::plot {

struct PlotStyle {
    QColor grid;
    QColor surface; // what the plot stands on
    QColor secondaryInk;
    QColor overlay;
    QColor limit;
    QColor violation;
    double lineWidth = 0;        // px
    double overlayLineWidth = 0; // px
    QFont axisFont;
    QLocale locale;
    QString limitLabel;
};

} // namespace campanel::plot
