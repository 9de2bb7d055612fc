// SPDX-License-Identifier: Apache-2.0
// One key of the numeric keypad: the whole cell is the touch target, the drawn key is slightly smaller.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: key

    property string glyph
    property string note
    property bool primary
    property bool quiet
    readonly property color inkColor: !enabled ? Theme.color.disabledInk : primary ? Theme.color.touchInk
        : quiet ? Theme.color.touch : Theme.color.ink

    background: Item {
        Rectangle {
            anchors { fill: parent; margins: Theme.size.outline }
            radius: Theme.size.radius
            color: !key.enabled ? Theme.color.inset
                : key.primary ? (key.down ? Theme.color.touchPressed : Theme.color.touch)
                : key.down ? Theme.color.touchTint : Theme.color.inset
            border { width: Theme.size.hairline; color: key.primary && key.enabled ? Theme.color.touch : Theme.color.line }
        }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors.centerIn: parent
            IconLabel {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: key.glyph.length > 0
                code: key.glyph
                color: key.inkColor
                font.pixelSize: Theme.size.value
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: text.length > 0
                width: Math.min(implicitWidth, key.width - 2 * Theme.size.accent)
                fontSizeMode: Text.HorizontalFit
                text: key.text
                color: key.inkColor
                font { pixelSize: key.glyph.length > 0 || key.note.length > 0 ? Theme.size.body : Theme.size.value; weight: Font.DemiBold }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                visible: text.length > 0
                text: key.note
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
