// SPDX-License-Identifier: Apache-2.0
// The position in a list that can be scrolled; for display only.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    required property Flickable view
    readonly property real room: visible ? 2 * width : 0   // that the rows leave it

    visible: view.visibleArea.heightRatio < 1
    x: parent.width - width
    y: view.y + view.visibleArea.yPosition * view.height
    width: Theme.size.accent
    height: Math.max(Theme.size.touch / 2, view.visibleArea.heightRatio * view.height)
    radius: width / 2
    color: Theme.color.target
}
