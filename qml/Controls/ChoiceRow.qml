// SPDX-License-Identifier: Apache-2.0
// One entry of a list of choices: sign, text, a note below, a tick when it is selected. `leftPadding` is free for a picture.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: entry

    property string glyph
    property string note
    property bool holds
    property color noteColor: Theme.color.secondaryInk

    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: entry.holds || entry.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: entry.holds ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        IconLabel {
            id: sign
            anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            visible: entry.glyph.length > 0
            code: entry.glyph
            color: entry.holds ? Theme.color.touch : Theme.color.secondaryInk
        }
        Column {
            anchors { left: parent.left; right: tick.left; margins: Theme.size.padding; leftMargin: Theme.size.padding + entry.leftPadding + (sign.visible ? sign.width + Theme.size.padding : 0); verticalCenter: parent.verticalCenter }
            spacing: Theme.size.outline
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                wrapMode: Text.Wrap    // below the smallest size; a word only where it is wider than the row
                text: entry.text
                color: entry.enabled ? Theme.color.ink : Theme.color.disabledInk
                font.weight: Font.DemiBold
            }
            Label {
                visible: text.length > 0
                width: parent.width
                text: entry.note
                wrapMode: Text.WordWrap
                color: entry.noteColor
                font.pixelSize: Theme.size.caption
            }
        }
        IconLabel {
            id: tick
            anchors { right: parent.right; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            opacity: entry.holds ? 1 : 0
            code: Theme.icon.check
            color: Theme.color.touch
        }
    }
}
