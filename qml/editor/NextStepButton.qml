// SPDX-License-Identifier: Apache-2.0
// The next step: use the suggestion, download, view the download, save the program that is open and in the controller, or
// nothing left to do. Its width does not depend on the step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Button {
    id: step

    readonly property bool busy: Editor.programDownload.busy
    readonly property bool asks: Editor.programDownload.state === ProgramDownload.State.Unconfirmed || Editor.programDownload.state === ProgramDownload.State.Unapproved   // the sheet does
    readonly property bool suggests: !busy && !Editor.programDownload.canDownload && Editor.suggestionText.length > 0
    readonly property bool saves: !busy && !suggests && !asks && !Editor.programDownload.canDownload && Editor.programDownload.canSave
        && Controller.active.isPresent && !ProgramNames.isOtherMotion && Editor.severity !== Editor.Severity.Bad
    readonly property bool settled: !busy && Editor.programDownload.state === ProgramDownload.State.NothingToDo && Editor.programDownload.saved

    objectName: "nextStep"
    level: suggests ? Editor.suggestionLevel : saves ? Access.Operator : Access.Viewer
    kind: Button.Primary
    enabled: busy || suggests || saves || asks || Editor.programDownload.canDownload
    text: busy ? qsTr("Downloading") : suggests ? Editor.suggestionText : saves ? Theme.fill(qsTr("Save %1"), [Controller.active.name])
        : settled ? qsTr("Saved") : qsTr("Download")
    note: busy ? Theme.number(100 * Editor.programDownload.progress, 0) + " %" : saves || settled ? qsTr("in the controller") : !Controller.fresh ? qsTr("no connection") : suggests ? "" : Controller.state === Controller.State.Running ? qsTr("next cycle") : qsTr("to the controller")
    onClicked: step.suggests ? Editor.applySuggestion() : step.saves ? Editor.saveToFlash() : Frame.open("Download/DownloadSheet", {})
}
