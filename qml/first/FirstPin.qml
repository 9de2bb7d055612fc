// SPDX-License-Identifier: Apache-2.0
// The first user with a PIN, or none for now.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Access
import CamPanel.Panel

FirstStep {
    NewUser { id: users }

    lit: "key"

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
        onClicked: users.add()
    }
}
