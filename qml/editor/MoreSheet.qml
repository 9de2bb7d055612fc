// SPDX-License-Identifier: Apache-2.0
// Further functions of the Motion page: visible curves, the table, undo, the less common parameters.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    required property bool showPosition
    required property bool showJerk
    required property bool compare
    signal positionToggled(bool on)
    signal jerkToggled(bool on)
    signal compareToggled(bool on)
    signal tableRequested()
    signal proofRequested()
    signal kindRequested()
    signal editRequested(var fields, int index, Item source)

    readonly property real half: Math.floor((body.width - body.spacing) / 2)

    title: qsTr("View and tools")
    panelWidth: width * 0.82
    panelHeight: (Editor.kind === Editor.Kind.RotaryCutter ? 6 : 5) * Theme.size.touch + 3 * Theme.size.spacing + Theme.size.padding

    component Switch: ChoiceRow {
        width: sheet.half
    }

    Flow {
        id: body
        anchors.fill: parent
        spacing: Theme.size.spacing

        Switch {
            objectName: "positionSwitch"
            visible: Editor.handles === null   // the handles of a cam are on this curve
            text: qsTr("Position curve")
            note: sheet.showPosition ? qsTr("shown") : qsTr("hidden")
            holds: sheet.showPosition
            onClicked: sheet.positionToggled(!sheet.showPosition)
        }
        Switch {
            objectName: "jerkSwitch"
            text: qsTr("Jerk curve")
            note: sheet.showJerk ? qsTr("shown") : qsTr("hidden")
            holds: sheet.showJerk
            onClicked: sheet.jerkToggled(!sheet.showJerk)
        }
        Switch {
            text: qsTr("Compare with controller")
            note: sheet.compare ? qsTr("controller in grey") : qsTr("hidden")
            holds: sheet.compare
            onClicked: sheet.compareToggled(!sheet.compare)
        }
        SettingRow {
            objectName: "tableButton"
            width: sheet.half
            label: qsTr("Rows, pulses, errors")
            value: Editor.table.name.length > 0 ? Editor.table.name : qsTr("Table")
            onClicked: sheet.tableRequested()
        }
        SettingRow {
            objectName: "proofButton"
            width: sheet.half
            label: qsTr("Edited, active, saved")
            value: qsTr("Compare")
            onClicked: sheet.proofRequested()
        }
        FieldTile {
            visible: Editor.kind === Editor.Kind.RotaryCutter
            field: Editor.cutter.syncRatio
            compact: false
            width: sheet.half
            onEditRequested: (field, source) => sheet.editRequested([field], 0, source)
        }
        FieldTile {
            visible: Editor.kind === Editor.Kind.RotaryCutter
            field: Editor.cutter.rampSlices
            compact: false
            width: sheet.half
            onEditRequested: (field, source) => sheet.editRequested([field], 0, source)
        }
        SettingRow {
            objectName: "kindButton"
            width: sheet.half
            label: qsTr("Program")
            value: Editor.kindNames[Editor.kind - 1]
            onClicked: sheet.kindRequested()
        }
        Button {
            width: sheet.half
            height: Theme.size.touch
            glyph: Theme.icon.revert
            text: qsTr("Restore stored recipe")
            enabled: Editor.edited
            onClicked: {
                Editor.revert()
                sheet.closed()
            }
        }
    }
}
