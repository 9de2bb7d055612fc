// SPDX-License-Identifier: Apache-2.0
// One register: name, group and address, its value with unit and its raw value.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

TouchButton {
    id: row
    Accessible.name: row.name

    required property string name
    required property string note
    required property string value
    required property string raw
    required property bool writable
    required property bool known
    required property bool stale
    property bool holds

    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: row.holds || row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: row.holds ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors { left: parent.left; right: values.left; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
            Label {
                width: parent.width
                text: row.name
                fontSizeMode: Text.HorizontalFit
                font.weight: Font.DemiBold
            }
            Label {
                width: parent.width
                text: row.note
                fontSizeMode: Text.HorizontalFit
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Column {
            id: values
            anchors { right: mark.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            width: parent.width * 0.42
            Label {
                width: parent.width
                horizontalAlignment: Text.AlignRight
                text: row.value
                fontSizeMode: Text.HorizontalFit
                color: row.stale || !row.known ? Theme.color.disabledInk : Theme.color.ink
                font { pixelSize: Theme.size.title; weight: Font.Bold }
            }
            Label {
                width: parent.width
                visible: text.length > 0
                horizontalAlignment: Text.AlignRight
                text: row.raw
                color: row.stale ? Theme.color.disabledInk : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        IconLabel {
            id: mark
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            opacity: row.writable ? 1 : 0
            code: Theme.icon.edit
            color: Theme.color.touch
        }
    }
}
