// SPDX-License-Identifier: Apache-2.0
// How a curve plot looks, as plain values: what all have in common, and what the painting code needs to know
// of the item's properties.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>

namespace campanel::plot {

inline constexpr double cursorWidth = 1.5; // px
inline constexpr double dotRadius = 4;     // px, where the cursor meets a curve
inline constexpr double labelGap = 8;      // px between canvas and labels

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
