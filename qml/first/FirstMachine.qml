// SPDX-License-Identifier: Apache-2.0
// The main numbers of the machine on one screen, the others behind a key: they have useful defaults. The drawing marks the
// chosen one, a text explains it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

FirstStep {
    id: step

    readonly property list<string> mainNames: ["knife_radius_mm", "knives", "pulses_per_motor_rev", "gear_numerator", "gear_denominator"]
    readonly property var fields: Array.from(Editor.machineFields)
    // A machine without these numbers shows all of its own.
    readonly property bool showsOthers: detail || !fields.some(field => mainNames.includes(field.fieldId))
    property EditorField chosen: shown(showsOthers)[0] as EditorField

    function shown(others: bool): var {
        return step.fields.filter(field => step.mainNames.includes(field.fieldId) !== others)
    }

    lit: "machine"
    fieldId: chosen?.fieldId ?? ""
    onShowsOthersChanged: chosen = shown(showsOthers)[0] as EditorField

    Flickable {
        id: list
        objectName: "firstMachine"
        width: parent.width
        height: step.height
        contentHeight: grid.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Grid {
            id: grid
            columns: 2
            spacing: Theme.size.spacing
            width: list.width - scrollMark.room
            readonly property real cell: Math.floor((width - spacing) / 2)
            Repeater {
                model: step.shown(step.showsOthers)
                FieldTile {
                    required property var modelData
                    objectName: "first_" + item.fieldId
                    item: modelData as EditorField
                    compact: false
                    width: grid.cell
                    height: Theme.size.touch
                    onClicked: step.chosen = item
                }
            }
            SettingRow {
                objectName: "firstOthers"
                visible: !step.showsOthers && !step.narrow
                width: grid.cell
                height: Theme.size.touch
                label: qsTr("Limits and more")
                value: qsTr("as set")
                onClicked: step.detail = true
            }
        }
    }
    ScrollMark {
        id: scrollMark
        parent: list
        view: list
    }
    notes: Label {
        width: parent.width
        height: Math.min(implicitHeight, 0.34 * step.height)
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: step.chosen?.explanation ?? ""
        color: Theme.color.secondaryInk
    }
}
