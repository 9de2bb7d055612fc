// SPDX-License-Identifier: Apache-2.0
// Curves in the colors and sizes of the theme.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Plot

CurvePlot {
    id: plot

    gridColor: Theme.color.line
    inkColor: Theme.color.ink
    secondaryInkColor: Theme.color.secondaryInk
    surfaceColor: Theme.color.surface
    positionColor: Theme.color.position
    velocityColor: Theme.color.touch
    accelerationColor: Theme.color.acceleration
    jerkColor: Theme.color.jerk
    frequencyColor: Theme.color.frequency
    overlayColor: Theme.color.target
    traceColor: Theme.color.touch
    limitColor: Theme.color.warning
    violationColor: Theme.color.fault
    lineWidth: Theme.size.curve
    overlayLineWidth: Theme.size.curve
    traceLineWidth: Theme.size.curve
    axisFont: Theme.captionFont
    titleFont: Theme.captionFont
    timeUnit: "s"

    Binding {
        target: plot
        property: "locale"
        value: Theme.locale
    }
}
