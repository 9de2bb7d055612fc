// SPDX-License-Identifier: Apache-2.0
// The correction of the distance from mark sensor to knife with bags and a ruler, step by step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property MarkWizard wizard: Maintenance.packing.wizard
    readonly property int step: wizard.step
    readonly property bool waits: step === MarkWizard.Step.Cutting || step === MarkWizard.Step.Watch
    readonly property bool ended: step === MarkWizard.Step.Done || step === MarkWizard.Step.Failed
    readonly property bool showsDistances: step === MarkWizard.Step.Confirm || step === MarkWizard.Step.Writing
        || step === MarkWizard.Step.Watch || step === MarkWizard.Step.Done

    pending: step !== MarkWizard.Step.Explain && step !== MarkWizard.Step.Watch && !ended
    title: qsTr("Mark sensor to knife")
    note: sheet.ended ? "" : [qsTr("Step 1 of 5: introduction"), qsTr("Step 2 of 5: cut bags"), qsTr("Step 3 of 5: measure"),
        qsTr("Step 4 of 5: write"), qsTr("Step 4 of 5: write"), qsTr("Step 5 of 5: check")][sheet.step]
    panelWidth: width * 0.9

    component Pair: Readout {
        property bool strong
        pixelSize: Theme.size.title
        ink: strong ? Theme.color.touch : Theme.color.ink
    }

    Label {
        id: words
        objectName: "wizardText"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        wrapMode: Text.WordWrap
        text: sheet.wizard.text
        color: sheet.step === MarkWizard.Step.Failed ? Theme.color.fault : Theme.color.ink
    }
    Label {
        id: reason
        objectName: "wizardReason"
        anchors { left: parent.left; right: parent.right; top: words.bottom; topMargin: Theme.size.spacing }
        wrapMode: Text.WordWrap
        visible: text.length > 0
        text: sheet.wizard.blockedReason
        color: Theme.color.warning
        font.weight: Font.DemiBold
    }
    ProgressBar {
        anchors { left: parent.left; right: parent.right; top: reason.visible ? reason.bottom : words.bottom; topMargin: Theme.size.padding }
        visible: sheet.waits
        progress: sheet.wizard.progress
    }
    CutterDrawing {
        anchors { left: parent.left; right: parent.right; top: reason.visible ? reason.bottom : words.bottom; bottom: distances.top; margins: Theme.size.padding; topMargin: 2 * Theme.size.padding }
        visible: height > 2 * Theme.size.touch && sheet.step !== MarkWizard.Step.Failed
        showsBags: true
        offset: sheet.step === MarkWizard.Step.Watch || sheet.step === MarkWizard.Step.Done ? 0 : 0.25
        marked: sheet.step === MarkWizard.Step.Confirm || sheet.step === MarkWizard.Step.Writing ? ["sensor"]
            : sheet.waits || sheet.step === MarkWizard.Step.Done ? ["film"] : ["offset"]
    }
    Row {
        id: distances
        anchors { left: parent.left; bottom: parent.bottom; bottomMargin: Theme.size.padding }
        spacing: Theme.size.padding * 2
        visible: sheet.showsDistances
        Pair {
            title: qsTr("Cut behind mark")
            text: sheet.wizard.meanText
        }
        Pair {
            title: qsTr("Target")
            text: sheet.wizard.offsetText
        }
        Pair {
            title: qsTr("Old distance")
            text: sheet.wizard.oldText
        }
        Pair {
            objectName: "wizardNew"
            title: qsTr("New distance")
            text: sheet.wizard.newText
            strong: true
        }
    }
    Row {
        anchors { left: parent.left; bottom: parent.bottom; bottomMargin: Theme.size.padding }
        spacing: Theme.size.padding * 2
        visible: sheet.step === MarkWizard.Step.Measure && sheet.wizard.measuredText.length > 0
        Pair {
            objectName: "wizardMeasured"
            title: qsTr("Measured")
            text: sheet.wizard.measuredText
        }
        Pair {
            title: qsTr("Mean")
            text: sheet.wizard.meanText
            strong: true
        }
    }
    footer: [
        Button {
            objectName: "wizardCancel"
            text: sheet.ended || sheet.step === MarkWizard.Step.Watch ? qsTr("Close") : qsTr("Cancel")
            onClicked: sheet.closed()
        },
        Button {
            objectName: "wizardDrop"
            Accessible.name: qsTr("Delete the measurement")
            visible: sheet.step === MarkWizard.Step.Measure
            enabled: sheet.wizard.measuredText.length > 0
            glyph: Theme.icon.backspace
            onClicked: sheet.wizard.dropMeasurement()
        },
        Button {
            objectName: "wizardRuler"
            visible: sheet.step === MarkWizard.Step.Measure && Controller.simulated
            enabled: sheet.wizard.canReadRuler
            text: qsTr("Read ruler")
            onClicked: sheet.wizard.measureSimulatedBag()
        },
        Button {
            objectName: "wizardEnter"
            level: sheet.wizard.measurement.neededLevel
            visible: sheet.step === MarkWizard.Step.Measure
            glyph: Theme.icon.edit
            text: qsTr("Enter …")
            onClicked: Frame.edit([sheet.wizard.measurement], 0, null, "")
        },
        Button {
            objectName: "wizardAgain"
            visible: sheet.ended
            text: qsTr("Measure again")
            onClicked: sheet.wizard.restart()
        },
        Button {
            objectName: "wizardNext"
            level: Access.Technician
            visible: !sheet.waits && !sheet.ended
            kind: Button.Primary
            enabled: sheet.wizard.canGoOn
            text: sheet.step === MarkWizard.Step.Confirm || sheet.step === MarkWizard.Step.Writing ? qsTr("Write") : qsTr("Next")
            onClicked: sheet.wizard.goOn()
        }
    ]
}
