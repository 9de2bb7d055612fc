// SPDX-License-Identifier: Apache-2.0
// The controller's setting by which it starts only with the panel's permit.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    title: qsTr("Start permit")

    Component.onCompleted: Controller.startPermit.readIfUncertain()
    Connections {
        target: Controller
        function onConnectionChanged(): void { Controller.startPermit.readIfUncertain() }
    }

    ParameterList {
        anchors { fill: parent; topMargin: section.bodyTop }
        name: "startPermit"
        fields: Controller.startPermit
    }
}
