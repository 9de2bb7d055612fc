// SPDX-License-Identifier: Apache-2.0
// A key of the command column: Start (outlined until it can be pressed), Stop (always filled), or one between them. With a hold time it acts
// once it has been held so long, under a ring that fills; a release or a finger that leaves the key before cancels.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

T.AbstractButton {
    id: key
    Accessible.role: Accessible.Button
    Accessible.name: key.text

    required property string glyph
    property string note
    property bool filled
    property bool ready: true              // false: drawn as not ready, but a touch still explains the reason
    property bool square: false            // a plain filled square instead of the glyph, unlike an emergency-stop button
    property bool small: false
    property int holdMs: 0
    readonly property bool holding: holdMs > 0 && pressed && !acted
    property bool acted: false             // since the last touch began
    readonly property bool tooShort: hint.running
    property color baseColor: Theme.color.good
    property color pressedColor: Theme.color.good
    readonly property color inkColor: filled ? Theme.color.stopInk : ready ? baseColor : Theme.color.disabledInk

    signal held()

    implicitWidth: Theme.size.commandKey
    implicitHeight: Theme.size.commandKey

    onPressedChanged: {
        if (pressed)
            acted = false
        else if (holdMs > 0 && !acted)
            hint.restart()
    }

    Timer {
        interval: key.holdMs
        running: key.holding
        onTriggered: {
            key.acted = true
            key.held()
        }
    }
    Timer {
        id: hint
        interval: 2000
    }
    background: Rectangle {
        radius: Theme.size.radius
        color: key.filled ? (key.down ? key.pressedColor : key.baseColor)
            : key.down || !key.ready ? Theme.color.inset : Theme.color.surface
        border { width: key.filled ? 0 : Theme.size.outline; color: key.ready ? key.baseColor : Theme.color.line }
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
                anchors.horizontalCenter: parent.horizontalCenter
                visible: !key.square
                code: key.glyph
                color: key.inkColor
                font.pixelSize: key.small ? Theme.size.icon : Theme.size.largeIcon

                Repeater {
                    model: key.holding ? 1 : 0
                    HoldRing {
                        anchors.centerIn: parent
                        width: Theme.size.largeIcon + 2 * Theme.size.spacing
                        height: width
                        time: key.holdMs
                        color: key.inkColor
                    }
                }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                width: key.width - Theme.size.spacing
                horizontalAlignment: Text.AlignHCenter
                wrapMode: Text.WordWrap
                text: key.text
                color: key.inkColor
                font { pixelSize: key.small ? Theme.size.body : Theme.size.command; bold: true }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: key.note.length > 0
                width: key.width - Theme.size.spacing
                horizontalAlignment: Text.AlignHCenter
                wrapMode: Text.WordWrap
                fontSizeMode: Text.HorizontalFit
                minimumPixelSize: Theme.size.caption - 4
                text: key.note
                color: key.ready ? key.inkColor : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
