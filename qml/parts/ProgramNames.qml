// SPDX-License-Identifier: Apache-2.0
// The names of the controller's program and of the open recipe, and how they differ.
pragma Singleton
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Panel

QtObject {
    readonly property string active: Theme.fill(qsTr("%1 · v%2"), [Controller.active.name, Controller.active.version])
    // The open recipe and its newest saved version, if it has one.
    readonly property string saved: Editor.recipeVersion === 0 ? Editor.recipeName : Theme.fill(qsTr("%1 · v%2"), [Editor.recipeName, Editor.recipeVersion])
    readonly property string open: Editor.recipeVersion === 0 ? Theme.fill(qsTr("%1, not saved"), [Editor.recipeName])
        : Theme.fill(Editor.edited ? qsTr("%1 · v%2, edited") : qsTr("%1 · v%2"), [Editor.recipeName, Editor.recipeVersion])
    readonly property bool isOtherVersion: Controller.active.isPresent && Controller.active.version !== Editor.recipeVersion
    // The machine would run another motion than the one on this panel. Other codes, for one, are another version alone.
    readonly property bool isOtherMotion: Controller.active.isPresent && (Controller.active.name !== Editor.recipeName
        || Controller.active.kind !== Editor.kind || Editor.programDownload.differenceCount > 0
        || isOtherVersion && Editor.severity === Editor.Severity.Bad)
}
