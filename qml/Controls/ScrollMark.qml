// SPDX-License-Identifier: Apache-2.0
// Shows that a list goes on, and where one is in it; not made to be touched.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    required property Flickable view

    visible: view.visibleArea.heightRatio < 1
    x: parent.width - width
    y: view.y + view.visibleArea.yPosition * view.height
    width: Theme.size.accent
    height: Math.max(Theme.size.touch / 2, view.visibleArea.heightRatio * view.height)
    radius: width / 2
    color: Theme.color.target
}
