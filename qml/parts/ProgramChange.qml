// SPDX-License-Identifier: Apache-2.0
// The change of one number of the running program: its keypad, then the sheet that tells what the change does and
// downloads it. Another recipe on the Motion page, and a number that the machine cannot execute, lead there.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

QtObject {
    id: change

    property EditorField field: null       // in the keypad
    property real before                   // its value then
    readonly property bool covered: Frame.covered

    function nameOf(name: string): string { return Editor.field(name).label }
    function begin(name: string, source: Item): void {
        if (Editor.recipeName !== Controller.active.name || Editor.kind !== Controller.active.kind) {
            Frame.openPage("motion")
            return
        }
        change.field = Editor.field(name)
        change.before = change.field.value
        Frame.edit([change.field], 0, source, "")
    }

    onCoveredChanged: {
        if (change.covered || change.field === null)
            return
        const isChanged = change.field.value !== change.before
        change.field = null
        if (isChanged && Editor.programDownload.canDownload)
            Frame.open("Download/DownloadSheet", {})
        else if (isChanged)
            Frame.openPage("motion")
    }
}
