// SPDX-License-Identifier: Apache-2.0
// The shelved alarms, until when and by whom, each with a key to unshelve it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: panel

    ListView {
        id: list
        anchors.fill: parent
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Alarms.shelved
        delegate: Rectangle {
            id: row
            required property int index
            required property string code
            required property string title
            required property string until
            required property string by
            width: list.width - scrollMark.room
            height: Theme.size.touch + Theme.size.accent
            color: Theme.color.surface
            Rectangle {
                anchors.bottom: parent.bottom
                width: parent.width
                height: Theme.size.hairline
                color: Theme.color.line
            }
            Column {
                anchors { left: parent.left; right: back.left; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
                Label {
                    width: parent.width
                    text: row.title
                    fontSizeMode: Text.HorizontalFit
                }
                Label {
                    objectName: "shelvedState"
                    width: parent.width
                    text: row.by.length > 0 ? Theme.fill(qsTr("%1 · %2 · by %3"), [row.code, row.until, row.by]) : Theme.fill(qsTr("%1 · %2"), [row.code, row.until])
                    fontSizeMode: Text.HorizontalFit
                    color: Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
            Button {
                id: back
                objectName: "unshelve" + row.index
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                text: qsTr("Unshelve")
                onClicked: Alarms.unshelve(row.index)
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    Label {
        objectName: "alarmsEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: Theme.size.padding }
        visible: list.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: qsTr("No alarm is shelved. To shelve a known warning for some hours, tap the warning in the list.")
        color: Theme.color.secondaryInk
    }
}
