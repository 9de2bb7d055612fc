// SPDX-License-Identifier: Apache-2.0
// A dial that a finger turns: it follows the finger around its center from any starting point.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Panel
import CamPanel.Plot

KnifeDial {
    id: dial

    required property DryRun run

    ringColor: Theme.color.line
    syncColor: Theme.color.sync
    cutColor: Theme.color.ink
    handColor: Theme.color.touch
    tipColor: Theme.color.touch
    surfaceColor: Theme.color.surface
    staleColor: Theme.color.target

    MouseArea {
        anchors.fill: parent
        enabled: dial.run.available
        preventStealing: true
        onPressed: mouse => dial.run.grab(mouse.x - width / 2, mouse.y - height / 2)
        onPositionChanged: mouse => dial.run.drag(mouse.x - width / 2, mouse.y - height / 2)
    }
}
