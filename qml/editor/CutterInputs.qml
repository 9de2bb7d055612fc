// SPDX-License-Identifier: Apache-2.0
// The inputs of a rotary cutter. The operator has bag length and rate; the technician has four values, two of them pinned,
// the ratios and the law.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: inputs

    required property bool technical
    signal moreRequested()
    signal curvesRequested()

    readonly property list<string> fields: ["bag_length_mm", "rate_bags_per_min", "base_speed_mm_per_s", "film_speed_mm_per_s"]
    readonly property var ratios: Array.from(["k1", "k2", "k3", "k4"], name => Editor.field(name))
    readonly property int columns: technical ? Theme.size.fieldColumns : 1
    readonly property int rows: 4 / Theme.size.fieldColumns + 2
    readonly property real rowHeight: (height - (rows - 1) * Theme.size.spacing) / rows
    readonly property real fieldHeight: technical ? rowHeight : (height - rowHeight - 2 * Theme.size.spacing) / 2

    Grid {
        id: grid
        width: parent.width
        columns: inputs.columns
        spacing: Theme.size.spacing
        Repeater {
            model: inputs.technical ? inputs.fields : inputs.fields.slice(0, 2)
            FieldTile {
                required property string modelData
                field: modelData
                compact: inputs.columns > 1
                digits: Math.round((inputs.technical ? 1 : 1.4) * Theme.size.value)
                width: (grid.width - (inputs.columns - 1) * grid.spacing) / inputs.columns
                height: inputs.fieldHeight
            }
        }
    }
    RatioGroup {
        id: ratioGroup
        objectName: "ratios"
        visible: inputs.technical
        anchors { left: grid.left; right: grid.right; top: grid.bottom; topMargin: Theme.size.spacing }
        height: inputs.rowHeight
        fields: inputs.ratios
        caption: Editor.cutter.ramps.stateText
        onClicked: Frame.open("Editor/RatioSheet", {})
    }
    SettingRow {
        objectName: "lawButton"
        visible: inputs.technical
        anchors { left: grid.left; right: moreButton.left; rightMargin: Theme.size.spacing; top: moreButton.top }
        height: inputs.rowHeight
        label: qsTr("Speed law")
        value: Editor.lawName
        onClicked: Frame.open("Editor/LawPicker", {})
    }
    Button {
        objectName: "curvesButton"
        visible: !inputs.technical
        anchors { left: grid.left; right: moreButton.left; rightMargin: Theme.size.spacing; top: moreButton.top }
        height: inputs.rowHeight
        glyph: Theme.icon.motion
        text: qsTr("Curves")
        note: qsTr("speeds, ratios, law")
        onClicked: inputs.curvesRequested()
    }
    Button {
        id: moreButton
        objectName: "more"
        Accessible.name: qsTr("View and tools")
        anchors { right: grid.right; bottom: parent.bottom }
        width: Theme.size.touch
        height: inputs.rowHeight
        glyph: Theme.icon.more
        onClicked: inputs.moreRequested()
    }
}
