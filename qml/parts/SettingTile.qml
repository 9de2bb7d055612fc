// SPDX-License-Identifier: Apache-2.0
// One setting by its name in campanel.toml: label and value; a tap opens its choices, the keypad or the keyboard, for the
// level of its row.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

SettingRow {
    id: tile

    required property string name
    readonly property SettingField field: Settings.setting(name)
    property var choices: field.choices    // {key, text, note} each
    property string heading: field.label   // of what a tap opens

    label: field.label
    level: field.neededLevel
    value: field.isText && field.shown.length === 0 ? Theme.unknownText : field.shown
    onClicked: {
        if (tile.field.isText) {
            if (Access.ask(tile.field.neededLevel))
                Frame.open("Parts/TextSheet", {
                    title: tile.heading, text: tile.field.shown, level: tile.field.neededLevel,
                    check: text => tile.field.problem(text), onAccepted: text => tile.field.enter(text)
                })
        } else if (tile.choices.length === 0)
            Frame.edit([tile.field], 0, tile, tile.heading)
        else if (Access.ask(tile.field.neededLevel))
            Frame.open("Controls/ListPicker", { title: tile.heading, level: tile.level, choices: tile.choices, current: tile.field.key, onChosen: key => tile.field.choose(key) })
    }
}
