// SPDX-License-Identifier: Apache-2.0
// A key that moves the axis while it is held: from the end of the ring until the finger is lifted or slides off.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

CommandButton {
    id: key

    required property Jog jog
    required property int direction        // 1 forward, -1 in reverse
    required property string glyph
    property string note
    readonly property bool moves: jog.held === direction
    readonly property color ink: moves ? Theme.color.touchInk : !jog.possible ? Theme.color.disabledInk : locked ? Theme.color.secondaryInk : Theme.color.touch
    readonly property bool inFront: Window.active

    implicitWidth: Theme.size.commandKey
    implicitHeight: Theme.size.commandKey

    ready: jog.possible && !Frame.covered
    ringHost: sign
    onPressed: jog.touch(direction)
    onCommanded: jog.press(direction)
    onInFrontChanged: acted = true
    onPressedChanged: {
        if (!pressed)
            jog.release(direction)
    }

    background: Rectangle {
        radius: Theme.size.radius
        color: key.moves ? Theme.color.touch : key.down || !key.jog.possible ? Theme.color.inset : Theme.color.surface
        border { width: Theme.size.outline; color: key.jog.possible && !key.locked ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors.centerIn: parent
            IconLabel {
                id: sign
                anchors.horizontalCenter: parent.horizontalCenter
                code: key.glyph
                color: key.ink
                font.pixelSize: Theme.size.largeIcon
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                text: key.text
                color: key.ink
                font { pixelSize: Theme.size.command; bold: true }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: key.note.length > 0
                text: key.note
                color: key.moves ? key.ink : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
