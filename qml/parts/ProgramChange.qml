// SPDX-License-Identifier: Apache-2.0
// The change of one number of the running program: its sheet, which tells what the change does and downloads it. Another recipe
// on the Motion page leads there.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

QtObject {
    function nameOf(name: string): string { return Editor.field(name).label }
    function begin(name: string): void {
        if (Editor.recipeName !== Controller.active.name || Editor.kind !== Controller.active.kind)
            Frame.openPage("motion")
        else
            Frame.open("Download/ChangeSheet", { name: name })
    }
}
