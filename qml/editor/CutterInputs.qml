// SPDX-License-Identifier: Apache-2.0
// The inputs of a rotary cutter: four values, two of them pinned, the ratios, the law.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: inputs

    signal moreRequested()

    readonly property list<string> fields: ["bag_length_mm", "rate_bags_per_min", "base_speed_mm_per_s", "film_speed_mm_per_s"]
    readonly property var ratios: Array.from(["k1", "k2", "k3", "k4"], name => Editor.field(name))
    readonly property int columns: Theme.size.fieldColumns
    readonly property int rows: 4 / columns + 2
    readonly property real rowHeight: (height - (rows - 1) * Theme.size.spacing) / rows

    Grid {
        id: grid
        width: parent.width
        columns: inputs.columns
        spacing: Theme.size.spacing
        Repeater {
            model: inputs.fields
            FieldTile {
                required property string modelData
                field: modelData
                compact: inputs.columns > 1
                width: (grid.width - (inputs.columns - 1) * grid.spacing) / inputs.columns
                height: inputs.rowHeight
            }
        }
    }
    RatioGroup {
        id: ratioGroup
        objectName: "ratios"
        anchors { left: grid.left; right: grid.right; top: grid.bottom; topMargin: Theme.size.spacing }
        height: inputs.rowHeight
        fields: inputs.ratios
        caption: Editor.cutter.ramps.stateText
        onClicked: Frame.open("Editor/RatioSheet", {})
    }
    SettingRow {
        objectName: "lawButton"
        anchors { left: grid.left; right: moreButton.left; rightMargin: Theme.size.spacing; top: moreButton.top }
        height: inputs.rowHeight
        label: qsTr("Speed law")
        value: Editor.lawName
        onClicked: Frame.open("Editor/LawPicker", {})
    }
    Button {
        id: moreButton
        objectName: "more"
        Accessible.name: qsTr("View and tools")
        anchors { right: grid.right; top: ratioGroup.bottom; topMargin: Theme.size.spacing }
        width: Theme.size.touch
        height: inputs.rowHeight
        glyph: Theme.icon.more
        onClicked: inputs.moreRequested()
    }
}
