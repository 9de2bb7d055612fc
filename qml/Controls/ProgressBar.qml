// SPDX-License-Identifier: Apache-2.0
// The progress of a long operation, 0..1.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    id: bar

    required property real progress

    implicitHeight: Theme.size.spacing * 2
    radius: height / 2
    color: Theme.color.line

    Rectangle {
        width: Math.max(parent.height, parent.width * Math.min(1, Math.max(0, bar.progress)))
        height: parent.height
        radius: height / 2
        color: Theme.color.touch
    }
}
