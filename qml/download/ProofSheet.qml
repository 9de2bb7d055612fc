// SPDX-License-Identifier: Apache-2.0
// The three programs - edited, active, saved - and the proof of the active one: its table read back and compared.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property ProgramProof proof: Editor.programDownload.proof
    readonly property bool equal: proof.result === ProgramProof.Equal
    readonly property bool different: proof.result === ProgramProof.Different

    title: qsTr("Program in the controller")
    panelWidth: width * 0.86
    panelHeight: height * 0.9

    component Entry: Column {
        id: entry
        required property string name
        required property string value
        property bool live: true
        width: parent.width
        spacing: Theme.size.outline
        Label {
            text: entry.name
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            width: parent.width
            wrapMode: Text.WordWrap
            text: entry.value
            color: entry.live && !Controller.fresh ? Theme.color.disabledInk : Theme.color.ink
            font.weight: Font.DemiBold
        }
    }

    Column {
        id: states
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        Entry {
            live: false
            name: qsTr("Edited on this panel")
            value: Editor.programDownload.differenceCount > 0 && Controller.fresh ? Theme.fill(qsTr("%1, differences from the active program: %2"), [ProgramNames.saved, Editor.programDownload.differenceCount])
                : ProgramNames.saved
        }
        Entry {
            objectName: "proofActive"
            name: Controller.fresh ? qsTr("Active in the controller") : qsTr("Active in the controller (last known)")
            value: sheet.proof.activeText
        }
        Entry {
            objectName: "proofSaved"
            name: Controller.fresh ? qsTr("Saved in the controller") : qsTr("Saved in the controller (last known)")
            value: sheet.proof.savedText
        }
    }
    Rectangle {
        id: rule
        anchors { left: parent.left; right: parent.right; top: states.bottom; topMargin: Theme.size.spacing }
        height: Theme.size.hairline
        color: Theme.color.line
    }
    IconLabel {
        id: mark
        anchors { left: parent.left; top: rule.bottom; topMargin: Theme.size.spacing }
        visible: sheet.equal || sheet.different
        code: sheet.equal ? Theme.icon.good : Theme.icon.alert
        color: sheet.equal ? Theme.color.good : Theme.color.fault
    }
    Label {
        objectName: "proofText"
        anchors { left: mark.visible ? mark.right : parent.left; leftMargin: mark.visible ? Theme.size.spacing : 0; right: parent.right; top: rule.bottom; topMargin: Theme.size.spacing; bottom: bar.top; bottomMargin: Theme.size.accent }
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: sheet.proof.text
        color: sheet.different ? Theme.color.fault : Theme.color.ink
    }
    ProgressBar {
        id: bar
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        visible: sheet.proof.running
        progress: sheet.proof.progress
    }
    footer: [
        Button {
            objectName: "proofCancel"
            text: sheet.proof.running ? qsTr("Cancel") : qsTr("Close")
            onClicked: sheet.proof.running ? sheet.proof.cancel() : sheet.closed()
        },
        Button {
            objectName: "proofCompare"
            kind: Button.Primary
            enabled: sheet.proof.canCompare
            text: qsTr("Compare with the controller")
            onClicked: sheet.proof.compare()
        }
    ]
}
