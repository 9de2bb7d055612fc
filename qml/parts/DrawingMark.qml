// SPDX-License-Identifier: Apache-2.0
// A letter of a drawing; the marked one is in the color of what is touched.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: mark

    required property string letter
    property bool marked

    width: Math.max(letters.implicitWidth + Theme.size.spacing, height)
    height: Math.round(1.5 * Theme.size.body)
    radius: height / 2
    color: marked ? Theme.color.touch : Theme.color.surface
    border { width: Theme.size.hairline; color: marked ? Theme.color.touch : Theme.color.line }
    Label {
        id: letters
        anchors.centerIn: parent
        text: mark.letter
        color: mark.marked ? Theme.color.touchInk : Theme.color.ink
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
}
