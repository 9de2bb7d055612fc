// SPDX-License-Identifier: Apache-2.0
// One register: name, group and address, its value with unit and its raw value.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    required property string name
    required note
    required property string value
    required property string raw
    required property bool writable
    required property bool known
    required property bool stale

    text: name
    mark: ""
    noteLabel.text: writable ? qsTr("%1 · can be written").arg(note) : note
    rightText: value
    rightLabel { color: stale || !known ? Theme.color.disabledInk : Theme.color.ink; font { pixelSize: Theme.size.title; weight: Font.DemiBold } }
    rightNote: raw
    rightNoteLabel.color: stale ? Theme.color.disabledInk : Theme.color.secondaryInk
}
