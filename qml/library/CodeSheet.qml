// SPDX-License-Identifier: Apache-2.0
// The entry of a code of the chosen recipe by hand or by the scanner.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    id: sheet

    title: Recipes.codes.code === RecipeCodes.Film ? qsTr("Film reel of %1: scan the code or enter it").arg(Recipes.chosenName)
        : qsTr("Code of %1: scan or enter it (empty: the name)").arg(Recipes.chosenName)
    text: Recipes.codes.wanted
    level: Access.Technician
    problem: Recipes.codes.problem
    onEdited: text => Recipes.codes.wanted = text
    onAccepted: Recipes.codes.store()

    Connections {
        target: Scan
        function onCodeRead(code: string) { sheet.fill(code) }
    }
    QtObject {
        Component.onCompleted: Scan.beginEntry()
        Component.onDestruction: Scan.endEntry()
    }
}
