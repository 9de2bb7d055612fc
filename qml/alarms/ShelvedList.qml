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
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: Alarms.shelved
        delegate: ListRow {
            id: row
            required property int index
            required property string code
            required property string title
            required property string until
            required property string by
            tappable: false
            text: title
            note: by.length > 0 ? Theme.fill(qsTr("%1 · %2 · by %3"), [code, until, by]) : Theme.fill(qsTr("%1 · %2"), [code, until])
            noteLabel.objectName: "shelvedState"
            rightPadding: back.width
            Button {
                id: back
                objectName: "unshelve" + row.index
                level: Access.Operator
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                text: qsTr("Unshelve")
                onClicked: Alarms.unshelve(row.index)
            }
        }
    }
    ScrollMark { view: list }
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
