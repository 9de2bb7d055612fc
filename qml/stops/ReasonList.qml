// SPDX-License-Identifier: Apache-2.0
// The reasons of a shift by their time, longest first. Planned ones have an outline, open ones a gray bar.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    Label {
        id: heading
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding; bottomMargin: 0 }
        text: qsTr("Reasons by time")
        color: Theme.color.secondaryInk
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    ListView {
        id: list
        objectName: "reasonList"
        anchors { left: parent.left; right: parent.right; top: heading.bottom; bottom: parent.bottom; margins: Theme.size.padding; topMargin: Theme.size.accent }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        spacing: Theme.size.accent
        model: Stops.shift.reasons
        delegate: Item {
            id: row
            required property int index
            required property string text
            required property string durationText
            required property real share
            required property bool isPlanned
            required property bool isOpen
            width: list.width - scrollMark.room
            height: Theme.size.caption * 2.1
            Label {
                objectName: "reasonText" + row.index
                anchors { left: parent.left; right: time.left; rightMargin: Theme.size.spacing; top: parent.top }
                fontSizeMode: Text.HorizontalFit
                text: row.isPlanned ? qsTr("%1 (planned)").arg(row.text) : row.text
                font.pixelSize: Theme.size.caption
            }
            Label {
                id: time
                objectName: "reasonTime" + row.index
                anchors { right: parent.right; top: parent.top }
                text: row.durationText
                font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
            }
            Rectangle {
                anchors { left: parent.left; bottom: parent.bottom }
                width: Math.max(Theme.size.accent, row.share * parent.width)
                height: Theme.size.caption * 0.5
                color: row.isPlanned ? "transparent" : row.isOpen ? Theme.color.target : Theme.color.warning
                border { width: row.isPlanned ? Theme.size.outline : 0; color: Theme.color.target }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    Label {
        objectName: "reasonsNone"
        anchors.centerIn: parent
        visible: Stops.shift.reasons.count === 0 && Stops.shift.content === ShiftView.Shown
        text: qsTr("No stop in this shift.")
        color: Theme.color.secondaryInk
    }
}
