// SPDX-License-Identifier: Apache-2.0
// The decision on unsaved edits before a scanned recipe is opened.
pragma ComponentBehavior: Bound
import CamPanel.Parts
import CamPanel.Panel

ConfirmSheet {
    title: qsTr("%1 is not saved").arg(Editor.recipeName)
    question: qsTr("The recipe was edited. Opening the scanned recipe %1 without saving discards the edits.").arg(Recipes.chosenName)
    ways: [{ key: "discard", text: qsTr("Discard edits"), primary: false, level: Access.Operator },
        { key: "save", text: qsTr("Save as version %1").arg(Recipes.nextVersion), primary: true, level: Access.Operator }]
    onChosen: key => Scan.openScanned(key === "save")
}
