// SPDX-License-Identifier: Apache-2.0
// One stop: begin and duration, reason, who gave it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

TouchButton {
    id: row

    required property string time
    required property string clockNote     // empty: the clock was set
    required property string durationText
    required property string reasonText
    required property string stateText
    required property string by
    required property bool isOpen

    implicitHeight: Theme.size.touch
    Accessible.name: row.time

    background: Rectangle {
        radius: Theme.size.radius
        color: row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Column {
            id: first
            anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            width: Math.round(parent.width * 0.26)
            Label {
                width: parent.width
                text: row.time
                fontSizeMode: Text.HorizontalFit
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                width: parent.width
                text: row.durationText
                fontSizeMode: Text.HorizontalFit
                font.weight: Font.DemiBold
            }
        }
        Column {
            anchors { left: first.right; leftMargin: Theme.size.padding; right: arrow.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: row.reasonText
                color: row.isOpen ? Theme.color.warning : Theme.color.ink
                font.weight: Font.DemiBold
            }
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                readonly property string given: row.by.length > 0 ? Theme.fill(qsTr("%1 · %2"), [row.stateText, row.by]) : row.stateText
                text: row.clockNote.length > 0 ? Theme.fill(qsTr("%1 · %2"), [given, row.clockNote]) : given
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        IconLabel {
            id: arrow
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            code: Theme.icon.next
            color: Theme.color.touch
        }
    }
}
