// SPDX-License-Identifier: Apache-2.0
// One number of the recipe or the machine by its name in recipe files, or an item of a list; a tap edits it, a held finger
// explains it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

Field {
    id: tile

    property string field
    property EditorField item: Editor.field(field)

    objectName: "field_" + item.fieldId
    label: item.label
    level: item.neededLevel
    value: item.text
    unit: item.unit
    pinned: item.pinned
    derived: item.derived
    visible: item.visible
    onClicked: Frame.edit([tile.item], 0, tile, "")
    onExplain: Frame.open("Explain/ExplanationSheet", { field: tile.item })
}
