// SPDX-License-Identifier: Apache-2.0
// The style of a curve plot as plain values: common constants, and the item properties that the painting code
// needs.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>

namespace campanel::plot {

inline constexpr double cursorWidth = 1.5; // px
inline constexpr double dotRadius = 4;     // px, at the cursor's intersection with a curve
inline constexpr double labelGap = 8;      // px between canvas and labels

struct PlotStyle {
    QColor grid;
    QColor surface; // background of the plot
    QColor secondaryInk;
    QColor overlay;
    QColor limit;
    QColor violation;
    double lineWidth = 0;        // px
    double overlayLineWidth = 0; // px
    QFont axisFont;
    QLocale locale;
    double labelGap = plot::labelGap; // px, wider where handles stand at the axis
    QString limitLabel;
};

} // namespace campanel::plot
