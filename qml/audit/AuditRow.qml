// SPDX-License-Identifier: Apache-2.0
// One row of the audit trail: time and user, object, old and new value.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

TouchButton {
    id: row
    Accessible.name: row.what

    required property string time
    required property string clockNote
    required property string who
    required property string what
    required property string object
    required property string change
    required property string problem

    implicitHeight: Theme.size.touch

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
            width: Math.round(parent.width * 0.3)
            Label {
                width: parent.width
                text: row.clockNote.length > 0 ? Theme.fill(qsTr("%1 · %2"), [row.time, row.clockNote]) : row.time
                fontSizeMode: Text.HorizontalFit
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                width: parent.width
                text: row.who
                fontSizeMode: Text.HorizontalFit
            }
        }
        Column {
            anchors { left: first.right; leftMargin: Theme.size.padding; right: arrow.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: row.object.length > 0 ? Theme.fill(qsTr("%1 · %2"), [row.what, row.object]) : row.what
                font.weight: Font.DemiBold
            }
            Label {
                width: parent.width
                visible: text.length > 0
                fontSizeMode: Text.HorizontalFit
                text: row.problem.length > 0 ? row.problem : row.change
                color: row.problem.length > 0 ? Theme.color.warning : Theme.color.secondaryInk
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
