// SPDX-License-Identifier: Apache-2.0
// The choice of the controller: found by a search on all ports, or simulated.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: step

    readonly property LinkDoctor doctor: Maintenance.doctor

    Column {
        width: parent.width
        spacing: Theme.size.spacing
        ChoiceRow {
            objectName: "firstSimulated"
            level: Access.Technician
            width: parent.width
            text: qsTr("Simulated controller")
            note: qsTr("for training and tests; can be changed in Settings at any time")
            holds: Controller.simulated && !step.doctor.running
            enabled: !step.doctor.running
            onClicked: {
                Settings.simulated = true
                Settings.applyConnection()
            }
        }
        ChoiceRow {
            objectName: "firstSearch"
            level: Access.Operator
            width: parent.width
            text: qsTr("Search for the controller")
            note: qsTr("all serial ports and settings; may take several minutes")
            holds: !Controller.simulated || step.doctor.running
            enabled: step.doctor.canBegin
            onClicked: step.doctor.search()
        }
        Label {
            objectName: "firstSearchText"
            width: parent.width
            wrapMode: Text.WordWrap
            text: step.doctor.running ? Theme.fill(qsTr("%1 · %2"), [step.doctor.progressText, step.doctor.triedText])
                : step.doctor.canTake ? step.doctor.foundText : Controller.connectionText
            color: step.doctor.canTake ? Theme.color.good : Theme.color.secondaryInk
        }
        ProgressBar {
            width: parent.width
            visible: step.doctor.running
            progress: step.doctor.progress
        }
        Row {
            spacing: Theme.size.spacing
            Button {
                objectName: "firstTake"
                level: Access.Technician
                visible: step.doctor.canTake
                kind: Button.Primary
                text: qsTr("Use this connection")
                onClicked: step.doctor.take()
            }
            Button {
                objectName: "firstSearchCancel"
                level: Access.Operator
                visible: step.doctor.running
                text: qsTr("Cancel")
                onClicked: step.doctor.cancel()
            }
        }
    }
}
