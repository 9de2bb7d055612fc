// SPDX-License-Identifier: Apache-2.0
// Login: the users with the level for the requested action, and the PIN pad for the selected one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

DigitPanel {
    id: sheet

    required property int level            // required level, Access.Viewer: any
    readonly property var everybody: Access.users
    readonly property var people: sheet.everybody.filter(user => user.level >= sheet.level)

    title: qsTr("Log in")
    sentence: sheet.level > Access.Viewer || Access.locked ? Access.refusalText(sheet.level) : qsTr("Choose your name.")
    pad {
        label: qsTr("PIN")
        ready: Access.chosen > 0 && !Access.waits && !Access.busy
        hintIsFault: Access.waits || Access.failed
        hint: Access.locked ? "" : Access.chosen === 0 ? qsTr("Choose your name, then enter your PIN.") : Access.waits ? Access.waitText
            : Access.busy ? qsTr("Please wait …") : Access.message.length > 0 ? Access.message : qsTr("Enter your PIN.")
        onAccepted: pin => Access.login(pin)
        onEdited: if (!Access.waits) Access.clearMessage()
    }
    Component.onCompleted: {
        Access.clearMessage()
        Access.chosen = sheet.people.length === 1 ? sheet.people[0].id : 0
    }

    ListView {
        id: list
        objectName: "loginUsers"
        anchors.fill: parent
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.people
        delegate: ChoiceRow {
            required property var modelData
            objectName: "login_" + modelData.name
            text: modelData.name
            note: modelData.levelText
            holds: Access.chosen === modelData.id
            onClicked: {
                sheet.pad.clear()
                Access.clearMessage()
                Access.chosen = modelData.id
                sheet.pad.forceActiveFocus() // a hardware keyboard types on
            }
        }
    }
    ScrollMark { view: list }
}
