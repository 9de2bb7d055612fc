// SPDX-License-Identifier: Apache-2.0
// The first user with a PIN, or none for now.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Access
import CamPanel.Panel

FirstStep {
    id: step

    property string userName
    property int userLevel: Access.Service

    Column {
        width: parent.width
        spacing: Theme.size.padding
        Label {
            objectName: "firstPinText"
            width: parent.width
            wrapMode: Text.WordWrap
            text: Access.protectedByPins
                ? qsTr("%1 is set. Add other users in Settings > Users: operators start, stop and change bag length and rate, technicians also set cam and machine.").arg(Access.userName)
                : qsTr("A PIN protects the cam, the machine and the connection; operators start, stop and change bag length and rate without a PIN. Until a PIN is set, all users have full access.")
        }
        Label {
            width: parent.width
            visible: Access.message.length > 0
            wrapMode: Text.WordWrap
            text: Access.message
            color: Access.failed ? Theme.color.fault : Theme.color.secondaryInk
        }
        Button {
            objectName: "firstSetPin"
            visible: !Access.protectedByPins
            text: qsTr("Set the first PIN")
            onClicked: {
                step.userName = Access.freeName(step.userLevel)
                step.page.sheetRequested(userSheet)
            }
        }
    }
    Component {
        id: userSheet
        NewUserSheet {
            name: step.userName
            onNameRequested: step.page.sheetRequested(nameSheet)
            onPinRequested: step.page.sheetRequested(pinSheet)
        }
    }
    Component {
        id: nameSheet
        TextSheet {
            title: qsTr("Name of the user")
            text: step.userName
            problem: Access.nameRefusal(step.userName)
            onEdited: text => step.userName = text
            onAccepted: step.page.sheetRequested(userSheet)
        }
    }
    Component {
        id: pinSheet
        NewPinSheet {
            title: qsTr("PIN of %1").arg(step.userName)
            level: Access.Service
            onEntered: pin => {
                Access.addUser(step.userName, step.userLevel, pin)
                closed()
            }
        }
    }
}
