// SPDX-License-Identifier: Apache-2.0
// A key of the command column: Start (outlined until it can be pressed), Stop (always filled), or one between them.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

CommandButton {
    id: key

    required property string glyph
    property string note: holdNote
    property bool filled
    property bool square: false            // a plain filled square instead of the glyph, unlike an emergency-stop button
    property bool small: false
    readonly property color inkColor: filled ? Theme.color.stopInk : ready && !locked ? Theme.color.touch : Theme.color.secondaryInk

    ringHost: sign
    ringColor: key.inkColor
    implicitWidth: Theme.size.commandKey
    implicitHeight: Theme.size.commandKey

    background: Rectangle {
        radius: Theme.size.radius
        color: key.filled ? (key.down ? Theme.color.stopPressed : Theme.color.stop)
            : key.down || !key.ready ? Theme.color.inset : Theme.color.surface
        border { width: Theme.size.outline; color: key.filled ? Theme.color.stopEdge : key.ready && !key.locked ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors.centerIn: parent
            spacing: Theme.size.spacing
            Item {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: key.square
                width: Theme.size.largeIcon
                height: Theme.size.largeIcon
                Rectangle {
                    anchors { fill: parent; margins: Theme.size.accent }
                    radius: Theme.size.accent
                    color: key.inkColor
                }
            }
            IconLabel {
                id: sign
                anchors.horizontalCenter: parent.horizontalCenter
                visible: !key.square
                code: key.glyph
                color: key.inkColor
                font.pixelSize: key.small ? Theme.size.icon : Theme.size.largeIcon
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                width: key.width - Theme.size.spacing
                horizontalAlignment: Text.AlignHCenter
                wrapMode: Text.Wrap            // a word only where it is wider than the key
                text: key.text
                color: key.inkColor
                font { pixelSize: key.small ? Theme.size.body : Theme.size.command; bold: true }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: key.note.length > 0
                width: key.width - Theme.size.spacing
                horizontalAlignment: Text.AlignHCenter
                wrapMode: key.height > 1.5 * Theme.size.commandKey ? Text.WordWrap : Text.NoWrap
                fontSizeMode: Text.HorizontalFit
                text: key.note
                color: key.ready ? key.inkColor : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
