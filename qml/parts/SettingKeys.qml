// SPDX-License-Identifier: Apache-2.0
// The choices of one setting, by its name in campanel.toml, as a row of keys. Tests find a key by `keyName` and its value.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

Segmented {
    id: keys

    required property string name
    property string keyName
    property var glyphs: ({})              // by value
    readonly property SettingField field: Settings.setting(name)
    readonly property var all: field.choices

    level: field.neededLevel
    choices: all.map(each => Object.assign({ glyph: keys.glyphs[each.key] ?? "",
        name: keys.keyName + (each.key === true ? "On" : each.key === false ? "Off" : each.key) }, each))
    current: field.key
    onChosen: key => keys.field.choose(key)
}
