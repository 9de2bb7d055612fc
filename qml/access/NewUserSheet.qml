// SPDX-License-Identifier: Apache-2.0
// A new user: level and name, then the PIN. The first one has the level Service.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property int level
    required property string name
    readonly property var levels: Access.levels
    readonly property string refusal: Access.nameRefusal(sheet.name)
    signal nameRequested(int level, string name)
    signal pinRequested(int level, string name)

    pending: sheet.name !== Access.freeName(sheet.level) || sheet.level !== (Access.protectedByPins ? Access.Operator : Access.Service)
    title: qsTr("New user")
    panelHeight: Theme.size.touch * (Access.protectedByPins ? 6.6 : 5)

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
            Label {
                visible: !Access.protectedByPins
                width: parent.width
                wrapMode: Text.WordWrap
                text: qsTr("The first user has the level Service and adds the other users. Keep this PIN safe: a forgotten PIN cannot be read from the panel.")
            }
            SettingRow {
                objectName: "newUserName"
                width: parent.width
                label: qsTr("Name")
                value: sheet.name.length > 0 ? sheet.name : Theme.unknownText
                onClicked: sheet.nameRequested(sheet.level, sheet.name)
            }
            Repeater {
                model: Access.protectedByPins ? sheet.levels : []
                ChoiceRow {
                    required property var modelData
                    objectName: "level" + modelData.key
                    width: parent.width
                    text: modelData.text
                    note: modelData.note
                    holds: sheet.level === modelData.key
                    onClicked: {
                        const wasFree = sheet.name === Access.freeName(sheet.level)
                        sheet.level = modelData.key
                        if (wasFree)
                            sheet.name = Access.freeName(modelData.key)
                    }
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    footer: [
        Label {
            width: Math.min(implicitWidth, sheet.width / 2)
            height: Theme.size.touch
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: sheet.refusal
            color: Theme.color.fault
        },
        Button {
            objectName: "userPin"
            level: Access.Service
            kind: Button.Primary
            text: qsTr("Next: PIN")
            enabled: sheet.refusal.length === 0
            onClicked: sheet.pinRequested(sheet.level, sheet.name)
        }
    ]
}
