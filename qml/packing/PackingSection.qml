// SPDX-License-Identifier: Apache-2.0
// Commissioning of a packing machine: the marks compared with the recipe, the distance from their sensor to the knife, and
// the controller's parameters, some with a suggestion.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property PackingSetup setup: Maintenance.packing

    onShownChanged: shown => {
        if (shown)
            section.setup.open()
    }
    Connections {
        target: Controller
        function onConnectionChanged() {
            if (section.visible)
                section.setup.open()
        }
    }

    Item {
        id: marks
        anchors { left: parent.left; right: parent.right; top: parent.top }
        height: Math.round(1.2 * Theme.size.touch)
        Label {
            objectName: "packingTeachText"
            anchors { left: parent.left; right: keys.left; rightMargin: Theme.size.padding; top: parent.top; bottom: parent.bottom; bottomMargin: teachBar.visible ? teachBar.height : 0 }
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            verticalAlignment: Text.AlignVCenter
            text: section.setup.teachText
            color: section.setup.misfit ? Theme.color.warning : Theme.color.ink
        }
        ProgressBar {
            id: teachBar
            anchors { left: parent.left; right: keys.left; rightMargin: Theme.size.padding; bottom: parent.bottom }
            visible: section.setup.teaching
            progress: section.setup.teachProgress
        }
        Row {
            id: keys
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.spacing
            Button {
                objectName: "packingEdges"
                text: qsTr("Edges")
                onClicked: Frame.open("Packing/SensorEdgesSheet", {})
            }
            Button {
                objectName: "packingJam"
                text: qsTr("Jam")
                onClicked: Frame.open("Packing/JamSheet", {})
            }
            Button {
                objectName: "packingTeach"
                level: Access.Technician
                text: qsTr("Measure marks")
                enabled: section.setup.canTeach
                onClicked: section.setup.teach()
            }
            Button {
                objectName: "packingWizard"
                level: Access.Technician
                text: qsTr("Sensor to knife …")
                enabled: section.setup.available
                onClicked: {
                    if (!Access.ask(Access.Technician))
                        return
                    section.setup.wizard.restart()
                    Frame.open("Packing/MarkWizardSheet", {})
                }
            }
        }
    }
    ParameterList {
        anchors { left: parent.left; right: parent.right; top: marks.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom }
        fields: section.setup.fields
        name: "packing"
    }
}
