// SPDX-License-Identifier: Apache-2.0
// Version, update and license, and the note that this panel is not a safety function.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    title: qsTr("CamPanel %1").arg(Qt.application.version)

    Rectangle {
        id: warning
        y: section.bodyTop
        width: parent.width
        height: safety.implicitHeight + 2 * Theme.size.padding
        radius: Theme.size.radius
        color: Theme.color.inset
        border { width: Theme.size.outline; color: Theme.color.warning }
        IconLabel {
            id: mark
            anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            code: Theme.icon.alert
            color: Theme.color.warning
        }
        Label {
            id: safety
            objectName: "safetySentence"
            anchors { left: mark.right; right: parent.right; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
            wrapMode: Text.WordWrap
            text: qsTr("Stop on this panel is not a safety function. The machine needs a hard-wired emergency stop.")
            font.weight: Font.DemiBold
        }
    }
    Label {
        anchors { left: parent.left; right: parent.right; top: warning.bottom; bottom: versionsRow.top; topMargin: Theme.size.padding; bottomMargin: Theme.size.spacing }
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: qsTr("Touchscreen of an electronic-cam machine. CamPanel computes the cam, downloads the program to the motion controller and shows the controller's actual values.")
            + "\n\n" + qsTr("Licence: Apache 2.0. Made with Qt (LGPL 3), Qwt (Qwt licence 1.0), libmodbus (LGPL 2.1).")
        color: Theme.color.secondaryInk
    }
    ListRow {
        id: versionsRow
        objectName: "sectionVersions"
        anchors { left: parent.left; right: parent.right; bottom: updateRow.visible ? updateRow.top : updateState.top; bottomMargin: Theme.size.spacing }
        text: qsTr("Versions and disk")
        note: Versions.warning.length > 0 ? qsTr("The disk is too small") : qsTr("panel, gateway, controller, program")
        onClicked: section.settings.open("VersionsSection.qml")
    }
    ListRow {
        id: updateRow
        objectName: "softwareUpdate"
        level: Access.Service
        visible: SoftwareUpdate.available
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        text: qsTr("Update")
        note: qsTr("CamPanel %1").arg(Qt.application.version)
        Component.onCompleted: SoftwareUpdate.watched = true
        Component.onDestruction: SoftwareUpdate.watched = false
        onClicked: {
            if (Access.ask(Access.Service))
                Frame.open("Settings/UpdateSheet", {})
        }
    }
    Label {
        id: updateState
        objectName: "updateState"
        visible: !SoftwareUpdate.available
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        wrapMode: Text.Wrap
        text: SoftwareUpdate.stateText
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }

    Connections {
        target: SoftwareUpdate
        function onChosen() {
            Frame.open("Parts/ConfirmSheet", {
                title: SoftwareUpdate.actionText, question: SoftwareUpdate.question,
                ways: [{ key: "update", text: SoftwareUpdate.actionText, primary: true, level: Access.Service }],
                onChosen: () => {
                    SoftwareUpdate.confirm()
                    Frame.open("Settings/UpdateSheet", {})
                }
            })
        }
    }
}
