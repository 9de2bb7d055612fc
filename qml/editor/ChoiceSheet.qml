// SPDX-License-Identifier: Apache-2.0
// The options of one of the recipe's choices.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

ListPicker {
    id: sheet

    required property int row
    required property var options            // list of string

    level: Access.Technician
    choices: options.map((text, index) => ({ key: index, text: text }))
    onChosen: key => Editor.setChoice(sheet.row, key)
}
