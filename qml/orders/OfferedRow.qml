// SPDX-License-Identifier: Apache-2.0
// An order that the plant offers, with the key that puts it into the queue, or why it cannot be taken.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

ListRow {
    id: row

    required property int index
    required property string title
    required note
    required property bool usable

    objectName: "offered" + row.index
    tappable: false
    frame: Theme.size.hairline
    text: Theme.fill(qsTr("Offered: %1"), [row.title])
    noteLabel { wrapMode: Text.WordWrap; maximumLineCount: 2 }
    rightPadding: key.visible ? key.width + Theme.size.spacing : 0

    Button {
        id: key
        objectName: "offeredTake" + row.index
        anchors { right: parent.right; rightMargin: Theme.size.accent; verticalCenter: parent.verticalCenter }
        visible: row.usable
        level: Access.Operator
        text: qsTr("Take")
        onClicked: if (Access.ask(Access.Operator)) Orders.addOffered(row.index)
    }
}
