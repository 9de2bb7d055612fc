// SPDX-License-Identifier: Apache-2.0
// The machine data needed by the kind of program, and the limits that every recipe is checked against, beside a drawing
// that marks the chosen one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    property EditorField chosen: null      // the field that was touched last
    readonly property real rowHeight: Math.max(Theme.size.touch, (height - bodyTop - 4 * Theme.size.spacing) / 5)

    title: qsTr("Machine")

    Flickable {
        id: list
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom; topMargin: section.bodyTop }
        width: Math.round(parent.width * 0.5)
        contentHeight: column.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: column
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing
            SettingTile {
                objectName: "machineName"
                width: column.width
                height: section.rowHeight
                name: "machine.name"
            }
            SettingTile {
                objectName: "bagTolerance"
                visible: Editor.kind === Editor.Kind.RotaryCutter
                width: column.width
                height: section.rowHeight
                name: "bags.tolerance_mm"
                heading: qsTr("Bag tolerance ±")
            }
            SettingTile {
                objectName: "trimStep"
                visible: Controller.packing.present
                width: column.width
                height: section.rowHeight
                name: "hand.trim_step_mm"
            }
            ListRow {
                objectName: "openStops"
                width: column.width
                height: section.rowHeight
                text: qsTr("Stops and shifts")
                note: qsTr("Reasons, ideal rate")
                onClicked: section.settings.open("StopsSection.qml")
            }
            ListRow {
                objectName: "openMaster"
                width: column.width
                height: section.rowHeight
                text: qsTr("Master")
                note: Controller.masterSetting.text
                onClicked: section.settings.open("MasterSetupSection.qml")
            }
            ListRow {
                objectName: "openTower"
                width: column.width
                height: section.rowHeight
                text: qsTr("Light tower and horn")
                note: qsTr("What each state shows")
                onClicked: section.settings.open("TowerSection.qml")
            }
            ListRow {
                objectName: "openAxes"
                width: column.width
                height: section.rowHeight
                text: qsTr("Axes")
                note: qsTr("Pulses, direction")
                onClicked: section.settings.open("AxesSection.qml")
            }
            Repeater {
                model: Editor.machineFields
                Column {
                    id: line
                    required property var modelData
                    readonly property EditorField item: modelData as EditorField
                    readonly property bool measurable: item.fieldId === "pulses_per_motor_rev"
                    visible: item.visible
                    spacing: Theme.size.spacing
                    FieldTile {
                        item: line.item
                        compact: false
                        width: column.width
                        height: section.rowHeight
                        onClicked: section.chosen = item
                    }
                    Button {
                        objectName: "measureMainMotor"
                        visible: line.measurable
                        width: column.width
                        text: qsTr("Measure")
                        onClicked: {
                            section.chosen = line.item
                            Maintenance.measurement.beginMainMotor()
                            Frame.open("Settings/AxisSheet", {})
                        }
                    }
                }
            }
            ListRow {
                objectName: "openPermit"
                width: column.width
                height: section.rowHeight
                text: qsTr("Panel's permit")
                note: qsTr("Start")
                onClicked: section.settings.open("PermitSection.qml")
            }
        }
    }
    MachineDrawing {
        anchors { left: list.right; leftMargin: Theme.size.padding; right: parent.right; top: list.top }
        height: Math.min(parent.height - section.bodyTop, width)
        fieldId: section.chosen?.fieldId ?? ""
    }
    ScrollMark {
        id: scrollMark
        view: list
        x: list.width - width
    }
}
