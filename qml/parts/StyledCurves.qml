// SPDX-License-Identifier: Apache-2.0
// Curves in the colors and sizes of the theme.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Plot

CurvePlot {
    id: plot

    readonly property var metricUnits: ({ position: "mm", velocity: "mm/s", acceleration: "m/s²", jerk: "m/s³", frequency: "kHz", torque: "Nm" })
    factors: Array.from(plot.quantities, quantity => Theme.unitFactor(plot.metricUnits[quantity]))

    style.gridColor: Theme.color.line
    style.inkColor: Theme.color.ink
    style.secondaryInkColor: Theme.color.secondaryInk
    style.surfaceColor: Theme.color.surface
    style.positionColor: Theme.color.position
    style.velocityColor: Theme.color.touch
    style.accelerationColor: Theme.color.acceleration
    style.jerkColor: Theme.color.jerk
    style.frequencyColor: Theme.color.frequency
    style.torqueColor: Theme.color.acceleration
    style.overlayColor: Theme.color.target
    style.traceColor: Theme.color.touch
    style.limitColor: Theme.color.secondaryInk
    style.violationColor: Theme.color.fault
    style.lineWidth: Theme.size.curve
    style.overlayLineWidth: Theme.size.curve
    style.traceLineWidth: Theme.size.curve
    style.axisFont: Theme.captionFont
    style.titleFont: Theme.captionFont
    timeUnit: "s"

    Binding {
        target: plot.style
        property: "locale"
        value: Theme.locale
    }
}
