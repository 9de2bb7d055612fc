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

    required property MotionPage page
    signal kindRequested()

    readonly property real half: Math.floor((body.width - body.spacing) / 2)
    readonly property bool isCutter: Editor.kind === Editor.Kind.RotaryCutter

    title: qsTr("View and tools")
    panelWidth: width * 0.82
    header: [
        Button {
            objectName: "operatorHalf"
            visible: sheet.isCutter && sheet.page.technical && sheet.free === 0
            kind: Button.Quiet
            text: qsTr("Operator's page")
            onClicked: {
                sheet.page.showsCurves = false
                sheet.closed()
            }
        }
    ]
    panelHeight: body.height + Theme.size.touch + 2 * Theme.size.padding

    component Switch: ChoiceRow {
        width: sheet.half
    }
    component Tool: ListRow {
        width: sheet.half
    }

    Flickable {
        id: list
        anchors.fill: parent
        contentHeight: body.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Flow {
            id: body
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing

            Switch {
                objectName: "positionSwitch"
                visible: sheet.page.technical && Editor.handles === null   // the handles of a cam are on this curve
                text: qsTr("Position curve")
                note: sheet.page.showPosition ? qsTr("shown") : qsTr("hidden")
                holds: sheet.page.showPosition
                onClicked: sheet.page.showPosition = !sheet.page.showPosition
            }
            Switch {
                objectName: "jerkSwitch"
                visible: sheet.page.technical
                text: qsTr("Jerk curve")
                note: sheet.page.showJerk ? qsTr("shown") : qsTr("hidden")
                holds: sheet.page.showJerk
                onClicked: sheet.page.showJerk = !sheet.page.showJerk
            }
            Switch {
                objectName: "torqueSwitch"
                visible: sheet.page.technical && Editor.kind !== Editor.Kind.Press   // the work piece decides the torque of a press
                enabled: Editor.plot.hasTorque
                text: qsTr("Torque curve")
                note: !Editor.plot.hasTorque ? qsTr("needs the inertia, see Settings, Machine") : sheet.page.showTorque ? qsTr("shown") : qsTr("hidden")
                holds: sheet.page.showTorque && Editor.plot.hasTorque
                onClicked: sheet.page.showTorque = !sheet.page.showTorque
            }
            Switch {
                visible: sheet.page.technical
                text: qsTr("Compare with controller")
                note: sheet.page.compare ? qsTr("controller in grey") : qsTr("hidden")
                holds: sheet.page.compare
                onClicked: sheet.page.compare = !sheet.page.compare
            }
            Tool {
                objectName: "mapButton"
                visible: sheet.isCutter
                text: qsTr("Regime map")
                note: qsTr("Fastest rate over length")
                onClicked: Frame.open("Editor/RegimeSheet", {})
            }
            Tool {
                objectName: "tableButton"
                text: Editor.table.name.length > 0 ? Editor.table.name : qsTr("Table")
                note: qsTr("Rows, pulses, errors")
                onClicked: Frame.open("Editor/TableSheet", {})
            }
            Tool {
                objectName: "kindButton"
                text: qsTr("Program")
                note: Editor.kinds[Editor.kind - 1].name
                onClicked: sheet.kindRequested()
            }
            Repeater {
                model: Editor.choices
                Tool {
                    required property int index
                    required property string name
                    required property string valueText
                    required property list<string> options
                    required property int option
                    required property string group
                    // The others are among the inputs; a machine without an encoder has one master.
                    visible: group === "tools" && (Controller.masterSetting.available || option === options.length - 1)
                    objectName: "toolChoice" + index
                    level: Access.Technician
                    text: name
                    note: valueText
                    onClicked: if (Access.ask(Access.Technician)) Frame.open("Editor/ChoiceSheet", { title: name, row: index, options: options, current: option })
                }
            }
            Tool {
                objectName: "proofButton"
                text: qsTr("Compare")
                note: qsTr("Edited, active, saved")
                onClicked: Frame.open("Download/ProofSheet", {})
            }
            FieldTile {
                visible: sheet.isCutter
                field: "min_seal_time_ms"
                compact: false
                width: sheet.half
            }
            FieldTile {
                visible: sheet.isCutter
                field: "sync_ratio"
                compact: false
                width: sheet.half
            }
            FieldTile {
                visible: sheet.isCutter
                field: "slices_per_ramp"
                compact: false
                width: sheet.half
            }
            Button {
                width: sheet.half
                height: Theme.size.touch
                objectName: "restoreStored"
                glyph: Theme.icon.revert
                text: qsTr("Restore stored recipe")
                level: Access.Operator
                enabled: Editor.edited
                onClicked: {
                    Editor.revert()
                    sheet.closed()
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
}
