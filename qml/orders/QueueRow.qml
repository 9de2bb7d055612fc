// SPDX-License-Identifier: Apache-2.0
// An order that waits, with its keys: start, one place up, remove.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

ListRow {
    id: row

    required property int index
    required property string title
    required property string recipe
    required property string quantity
    required property string actionText
    signal removeRequested()

    tappable: false
    frame: Theme.size.hairline
    text: row.title
    note: row.recipe.length > 0 ? row.recipe + " · " + row.actionText : row.actionText
    rightText: row.quantity
    rightPadding: keys.width + Theme.size.spacing

    Row {
        id: keys
        anchors { right: parent.right; rightMargin: Theme.size.accent; verticalCenter: parent.verticalCenter }
        Button {
            objectName: "queueRaise" + row.index
            Accessible.name: qsTr("One place up")
            level: Access.Operator
            kind: Button.Quiet
            glyph: Theme.icon.capital
            enabled: row.index > 0
            onClicked: Orders.raise(row.index)
        }
        Button {
            objectName: "queueRemove" + row.index
            Accessible.name: qsTr("Remove")
            level: Access.Operator
            kind: Button.Quiet
            glyph: Theme.icon.remove
            onClicked: if (Access.ask(Access.Operator)) row.removeRequested()
        }
        Button {
            objectName: "queueStart" + row.index
            visible: !Orders.current.underWay
            level: Access.Operator
            text: qsTr("Start order")
            onClicked: Orders.start(row.index)
        }
    }
}
