// SPDX-License-Identifier: Apache-2.0
// The recipe of the new order. Then the form is there again.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

ListPicker {
    title: qsTr("Recipe of the order")
    level: Access.Operator
    choices: [{ key: "", text: qsTr("Any recipe") }, ...Recipes.choicesOf(Editor.Kind.RotaryCutter)]
    current: Orders.entry.recipe
    onChosen: key => {
        if (Access.ask(Access.Operator))
            Orders.entry.recipe = key
    }
    onClosed: Frame.open("Orders/NewOrderSheet", {})
}
