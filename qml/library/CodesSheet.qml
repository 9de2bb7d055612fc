// SPDX-License-Identifier: Apache-2.0
// The codes of the chosen recipe: its own, also as a QR code, and that of its film reel.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

Sheet {
    id: sheet

    title: qsTr("Codes of %1").arg(Recipes.chosenName)
    panelWidth: width * 0.86
    panelHeight: 4.2 * Theme.size.touch

    function enter(code: int): void {
        if (!Access.ask(Access.Technician))
            return
        Recipes.codes.enter(code)
        Frame.open("Library/CodeSheet", {})
    }

    Column {
        anchors { left: parent.left; right: picture.left; rightMargin: Theme.size.spacing; top: parent.top }
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "codeOfRecipe"
            level: Access.Technician
            width: parent.width
            label: qsTr("Code that selects the recipe")
            value: Recipes.codes.scanText
            onClicked: sheet.enter(RecipeCodes.Recipe)
        }
        SettingRow {
            objectName: "codeOfFilm"
            level: Access.Technician
            width: parent.width
            label: qsTr("Code of the film reel")
            value: Recipes.codes.filmText
            onClicked: sheet.enter(RecipeCodes.Film)
        }
    }
    QrCode {
        id: picture
        objectName: "recipeQr"
        anchors { right: parent.right; top: parent.top }
        width: height
        height: 2 * Theme.size.touch + Theme.size.spacing
        text: Recipes.codes.scanText
    }
}
