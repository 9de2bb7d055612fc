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
                ? qsTr("%1 is set. Operators start, stop and change bag length and rate; the cam and the machine are for technicians. Add the others in Settings > Users.").arg(Access.userName)
                : qsTr("With a PIN only those who know one change the cam, the machine and the connection. Operators start, stop and change bag length and rate without one. There is no PIN from the factory; until one is set, everybody may do everything.")
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
