// SPDX-License-Identifier: Apache-2.0
// One value that a download would change: name, active value, new value.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: row

    required property string name
    required property string activeText
    required property string editedText
    property bool header

    implicitHeight: Math.round(Theme.size.body * 2.1)

    Label {
        x: Theme.size.accent
        height: parent.height
        width: parent.width * 0.42
        fontSizeMode: Text.HorizontalFit
        text: row.name
    }
    Label {
        x: parent.width * 0.44
        height: parent.height
        width: parent.width * 0.26
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: row.activeText
        color: Theme.color.secondaryInk
        font.pixelSize: row.header ? Theme.size.caption : Theme.size.body
    }
    Label {
        x: parent.width * 0.72
        height: parent.height
        width: parent.width * 0.28 - Theme.size.padding
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: row.editedText
        color: row.header ? Theme.color.secondaryInk : Theme.color.touch
        font { pixelSize: row.header ? Theme.size.caption : Theme.size.body; weight: row.header ? Font.Normal : Font.Bold }
    }
    Rectangle {
        anchors.bottom: parent.bottom
        width: parent.width
        height: Theme.size.hairline
        color: Theme.color.line
    }
}
