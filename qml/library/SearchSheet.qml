// SPDX-License-Identifier: Apache-2.0
// The search for a recipe: the recipes that match stay in sight beside the title, and a touch on one ends the search.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    id: sheet

    readonly property SettingField order: Settings.setting("recipes.order")

    title: qsTr("Search for a recipe")
    note: Recipes.list.count === 1 ? qsTr("1 recipe") : qsTr("%1 recipes").arg(Recipes.list.count)
    text: Recipes.search
    pending: false                         // each letter takes effect at once
    onEdited: text => Recipes.search = text
    header: [
        ListView {
            id: list
            width: sheet.width / 2
            height: Theme.size.touch
            orientation: ListView.Horizontal
            boundsBehavior: Flickable.StopAtBounds
            clip: true
            model: Recipes.list
            delegate: KeypadKey {
                required property int index
                required property string name
                objectName: "found" + index
                width: Math.round(list.width / 2.3)
                height: list.height
                focusPolicy: Qt.NoFocus
                text: name
                onClicked: {
                    Recipes.choose(index)
                    sheet.closed()
                }
            }
        },
        Button {
            objectName: "recipeOrder"
            kind: Button.Quiet
            focusPolicy: Qt.NoFocus
            text: sheet.order.shown
            onClicked: sheet.order.chooseNext()
        }
    ]
}
