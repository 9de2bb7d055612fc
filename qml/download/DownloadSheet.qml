// SPDX-License-Identifier: Apache-2.0
// The changes of a download, its progress, and its cancellation. Closes at the end; the page names the next step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property bool busy: Editor.programDownload.busy
    readonly property bool asks: Editor.programDownload.state === ProgramDownload.State.Unconfirmed
    readonly property bool wantsReason: Editor.programDownload.state === ProgramDownload.State.Unapproved
    readonly property bool failed: Editor.programDownload.state === ProgramDownload.State.Failed

    title: qsTr("Download to the controller")
    panelHeight: Math.max(2, list.count + 1) * head.implicitHeight + 3 * Theme.size.touch + 2 * Theme.size.padding
    panelWidth: width * 0.86

    Connections {
        target: Editor.programDownload
        function onChanged() {
            if (Editor.programDownload.state === ProgramDownload.State.Applied)
                sheet.closed()
        }
    }
    DifferenceRow {
        id: head
        anchors { left: parent.left; right: parent.right; top: parent.top }
        visible: list.count > 0
        name: ""
        activeText: qsTr("In the controller")
        editedText: qsTr("On this panel")
        header: true
    }
    ListView {
        id: list
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: status.top; bottomMargin: Theme.size.spacing }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.programDownload.differences
        delegate: DifferenceRow { width: list.width }
    }
    ScrollMark { view: list }
    Label {
        anchors.fill: list
        visible: list.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: !Controller.fresh ? qsTr("No connection: the present program of the controller is unknown.")
            : Controller.active.isPresent ? qsTr("The controller already has this program.")
            : qsTr("The controller has no program yet; this recipe becomes its first program.")
        color: Theme.color.secondaryInk
    }
    covered: reasons.active
    SheetInPlace {
        id: reasons
        below: sheet
        source: "WindowReasonSheet.qml"
    }
    Column {
        id: status
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.accent
        Label {
            width: parent.width
            visible: text.length > 0
            wrapMode: Text.WordWrap
            text: Theme.unbroken(Editor.programDownload.text)
            color: sheet.failed ? Theme.color.fault : Theme.color.ink
        }
        ProgressBar {
            width: parent.width
            visible: sheet.busy
            progress: Editor.programDownload.progress
        }
    }
    footer: [
        Button {
            objectName: "downloadCancel"
            level: sheet.busy ? Access.Operator : Access.Viewer
            text: sheet.busy ? qsTr("Cancel download") : qsTr("Close")
            onClicked: sheet.busy ? Editor.cancelDownload() : sheet.closed()
        },
        Button {
            objectName: "downloadProof"
            visible: !Editor.programDownload.canDownload && !sheet.busy && !sheet.asks && !sheet.wantsReason && Controller.active.isPresent
            text: qsTr("Compare")
            onClicked: Frame.open("Download/ProofSheet", {})
        },
        Button {
            level: Access.Operator
            visible: Editor.programDownload.canSave && !sheet.busy && !sheet.asks && !sheet.wantsReason
            glyph: Theme.icon.save
            text: Theme.fill(qsTr("Save %1"), [Controller.active.name])
            onClicked: Editor.saveToFlash()
        },
        Button {
            objectName: "closeCam"
            level: Access.Technician
            visible: sheet.asks
            text: qsTr("Close the cam")
            onClicked: Editor.closeCam()
        },
        Button {
            objectName: "confirmAdvance"
            level: Access.Operator
            visible: sheet.asks
            kind: Button.Primary
            text: qsTr("Confirm advance")
            onClicked: Editor.confirmAdvance()
        },
        Button {
            objectName: "downloadReason"
            visible: sheet.wantsReason
            kind: Button.Primary
            text: qsTr("Give a reason …")
            onClicked: reasons.active = true
        },
        Button {
            objectName: "downloadStart"
            level: Access.Operator
            visible: !sheet.asks && !sheet.wantsReason
            kind: Button.Primary
            glyph: Theme.icon.download
            enabled: Editor.programDownload.canDownload
            text: sheet.failed ? qsTr("Try again") : qsTr("Download")
            onClicked: Editor.download()
        }
    ]
}
