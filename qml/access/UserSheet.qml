// SPDX-License-Identifier: Apache-2.0
// One user: level, PIN, and removal.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property int userId
    property bool sure                     // the first tap on Remove asks, the second one removes
    readonly property var everybody: Access.users
    readonly property var user: sheet.everybody.find(each => each.id === sheet.userId) ?? { name: "", level: Access.Operator }
    readonly property var levels: Access.levels
    signal pinRequested()

    title: sheet.user.name
    note: Access.message
    panelHeight: Theme.size.touch * 6

    Flickable {
        id: list
        anchors.fill: parent
        contentHeight: rows.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: rows
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing
            Repeater {
                model: sheet.levels
                ChoiceRow {
                    required property var modelData
                    objectName: "level" + modelData.key
                    level: Access.Service
                    width: rows.width
                    text: modelData.text
                    note: modelData.note
                    holds: sheet.user.level === modelData.key
                    onClicked: Access.changeLevel(sheet.userId, modelData.key)
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    footer: [
        Button {
            objectName: "userRemove"
            level: Access.Service
            glyph: Theme.icon.remove
            text: sheet.sure ? qsTr("Yes, remove") : qsTr("Remove")
            onClicked: {
                if (!Access.ask(Access.Service))
                    return
                if (sheet.sure) {
                    Access.removeUser(sheet.userId)
                    sheet.closed()
                }
                sheet.sure = true
            }
        },
        Button {
            objectName: "userPin"
            glyph: Theme.icon.key
            text: qsTr("New PIN")
            onClicked: sheet.pinRequested()
        }
    ]
    Component.onCompleted: Access.clearMessage()
}
