// SPDX-License-Identifier: Apache-2.0
// The choice of the controller: found with the usual settings in seconds, or with all settings, on a port that a person
// chooses, or simulated.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

FirstStep {
    id: step

    readonly property LinkDoctor doctor: Maintenance.doctor

    // The port that was chosen is used with the settings of the connection.
    function choosePort(): void {
        if (!Access.ask(Access.Technician))
            return
        Settings.simulated = false
        Settings.refreshPorts()
        Frame.open("Settings/PortPicker", {})
    }

    lit: "plug"

    ChoiceRow {
        objectName: "firstSearch"
        level: Access.Operator
        width: parent.width
        text: qsTr("Find the controller")
        note: qsTr("on all ports with the usual settings; takes seconds")
        holds: !Controller.simulated || step.doctor.running
        enabled: step.doctor.canBegin
        onClicked: step.doctor.searchUsual()
    }
    ChoiceRow {
        objectName: "firstPort"
        level: Access.Technician
        width: parent.width
        text: qsTr("Choose the port")
        note: Settings.portName.length > 0 ? Settings.portName : qsTr("by hand")
        enabled: !step.doctor.running
        onClicked: step.choosePort()
    }
    ChoiceRow {
        objectName: "firstSimulated"
        level: Access.Technician
        width: parent.width
        text: qsTr("Simulated controller")
        note: qsTr("for training; moves no machine")
        holds: Controller.simulated && !step.doctor.running
        enabled: !step.doctor.running
        onClicked: {
            Settings.simulated = true
            Settings.applyConnection()
        }
    }
    notes: [
        Label {
            objectName: "firstSearchText"
            width: parent.width
            wrapMode: Text.WordWrap
            text: step.doctor.running ? Theme.fill(qsTr("%1 · %2"), [step.doctor.progressText, step.doctor.triedText])
                : step.doctor.canTake ? step.doctor.foundText
                : step.doctor.offersSearch ? qsTr("No controller with the usual settings. All settings take up to 15 min for each port.")
                : Controller.connectionText
            color: step.doctor.canTake && !step.doctor.running ? Theme.color.good : Theme.color.secondaryInk
        },
        ProgressBar {
            width: parent.width
            visible: step.doctor.running
            progress: step.doctor.progress
        },
        Button {
            objectName: "firstTake"
            level: Access.Technician
            width: parent.width
            visible: step.doctor.canTake
            kind: Button.Primary
            text: qsTr("Use this connection")
            onClicked: step.doctor.take()
        },
        Button {
            objectName: "firstSearchAll"
            level: Access.Operator
            width: parent.width
            visible: step.doctor.offersSearch
            text: qsTr("Search all settings")
            onClicked: step.doctor.search()
        },
        Button {
            objectName: "firstConnect"
            level: Access.Technician
            width: parent.width
            visible: !step.doctor.running && !Settings.simulated && Settings.connectionDirty && Settings.portName.length > 0
            kind: Button.Primary
            text: qsTr("Connect")
            onClicked: Settings.applyConnection()
        },
        Button {
            objectName: "firstSearchCancel"
            level: Access.Operator
            width: parent.width
            visible: step.doctor.running
            text: qsTr("Cancel")
            onClicked: step.doctor.cancel()
        }
    ]
}
