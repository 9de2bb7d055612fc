// SPDX-License-Identifier: Apache-2.0
// One number of the recipe or the machine; a tap edits it, a held finger explains it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

Field {
    id: tile

    required property EditorField field

    label: field.label
    value: field.text
    unit: field.unit
    pinned: field.pinned
    derived: field.derived
    visible: field.visible
    onClicked: Frame.edit([tile.field], 0, tile)
    onExplain: Frame.open("Explain/ExplanationSheet", { field: tile.field })
}
