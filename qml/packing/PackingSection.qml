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
    readonly property PackingFields fields: section.setup.fields

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
            minimumPixelSize: Theme.size.caption - 2
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
                objectName: "packingTeach"
                text: qsTr("Measure marks")
                enabled: section.setup.canTeach
                onClicked: section.setup.teach()
            }
            Button {
                objectName: "packingWizard"
                text: qsTr("Sensor to knife …")
                enabled: section.setup.available
                onClicked: {
                    if (!Access.ask(Access.Technician))
                        return
                    section.setup.wizard.restart()
                    section.page.sheetRequested(wizardSheet)
                }
            }
        }
    }
    ListView {
        id: list
        objectName: "packingList"
        anchors { left: parent.left; right: parent.right; top: marks.bottom; bottom: foot.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: section.fields
        delegate: PackingRow {
            objectName: "packing" + index
            width: list.width - 2 * Theme.size.accent
            onClicked: {
                if (toggle || !Access.ask(Access.Technician))
                    return
                section.fields.select(index)
                section.page.sheetRequested(valueSheet)
            }
            onSwitched: on => section.fields.setOn(index, on)
            onSuggestionTaken: section.fields.takeSuggestion(index)
        }
    }
    ScrollMark { view: list }
    Item {
        id: foot
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        Label {
            objectName: "packingText"
            anchors { left: parent.left; right: save.left; rightMargin: Theme.size.padding; top: parent.top; bottom: parent.bottom }
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            minimumPixelSize: Theme.size.caption - 2
            verticalAlignment: Text.AlignVCenter
            text: section.fields.outcomeText.length > 0 ? section.fields.outcomeText
                : qsTr("Changes take effect at once. Press Save to keep the values after power-off.")
            color: section.fields.failed ? Theme.color.fault : section.fields.outcomeText.length > 0 ? Theme.color.ink : Theme.color.secondaryInk
        }
        Button {
            id: save
            objectName: "packingSave"
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            glyph: Theme.icon.save
            text: qsTr("Save")
            enabled: section.fields.unsaved
            onClicked: section.fields.save()
        }
    }

    Component {
        id: valueSheet
        ValueKeypad { value: section.fields.value }
    }
    Component {
        id: wizardSheet
        MarkWizardSheet {}
    }
}
