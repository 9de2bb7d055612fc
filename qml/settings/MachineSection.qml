// SPDX-License-Identifier: Apache-2.0
// The machine data needed by the kind of program, and the limits that every recipe is checked against.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property real half: (width - Theme.size.spacing - 2 * Theme.size.accent) / 2   // beside the scroll mark
    readonly property real rowHeight: Math.max(Theme.size.touch, (height - bodyTop - 4 * Theme.size.spacing) / 5)

    title: qsTr("Machine")

    Flickable {
        id: list
        anchors { fill: parent; topMargin: section.bodyTop }
        contentHeight: grid.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Grid {
            id: grid
            columns: 2
            spacing: Theme.size.spacing
            SettingRow {
                objectName: "bagTolerance"
                visible: Editor.kind === Editor.Kind.RotaryCutter
                width: section.half
                height: section.rowHeight
                label: qsTr("Bag tolerance")
                value: qsTr("±%1 mm").arg(Theme.number(Settings.bagToleranceMm, 2))
                onClicked: {
                    if (Access.ask(Access.Technician))
                        section.page.sheetRequested(toleranceKeypad)
                }
            }
            SettingRow {
                objectName: "openStops"
                width: section.half
                height: section.rowHeight
                label: qsTr("Reasons, ideal rate")
                value: qsTr("Stops and shifts")
                onClicked: (section.page as SettingsPage).openStops()
            }
            Repeater {
                model: Editor.machineFields
                FieldTile {
                    required property var modelData
                    objectName: "field_" + field.fieldId
                    field: modelData as EditorField
                    compact: false
                    width: section.half
                    height: section.rowHeight
                    onEditRequested: (field, source) => section.page.editRequested([field], 0, source)
                    onExplainRequested: field => section.page.explainRequested(field)
                }
            }
        }
    }
    Component {
        id: toleranceKeypad
        ValueKeypad { value: Settings.bagTolerance }
    }
    ScrollMark { view: list }
}
