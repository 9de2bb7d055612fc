// SPDX-License-Identifier: Apache-2.0
// The inputs of every kind but the rotary cutter, from its tables: numbers, choices, law, knots, segments. Scrolls when it is longer
// than the screen.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: inputs

    signal editRequested(var fields, int index, Item source)
    signal explainRequested(EditorField field)
    signal lawRequested()
    signal knotsRequested()
    signal segmentsRequested()
    signal choiceRequested(int row, string name, var options, int option)
    signal moreRequested()

    readonly property int columns: Theme.size.fieldColumns
    readonly property real cell: (grid.width - (columns - 1) * grid.spacing) / columns

    Flickable {
        id: list
        objectName: "inputList"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: moreButton.top; bottomMargin: Theme.size.spacing }
        contentHeight: body.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Column {
            id: body
            width: parent.width - 2 * Theme.size.accent
            spacing: Theme.size.spacing

            SettingRow {
                objectName: "lawButton"
                visible: Editor.hasLaw
                width: body.width
                label: Editor.lawTitle
                value: Editor.lawName
                onClicked: inputs.lawRequested()
            }
            SettingRow {
                objectName: "knotsButton"
                visible: Editor.kind === Editor.Kind.PointCam
                width: body.width
                label: qsTr("Knots")
                value: Editor.cam.knots.count
                onClicked: inputs.knotsRequested()
            }
            SettingRow {
                objectName: "segmentsButton"
                visible: Editor.kind === Editor.Kind.SegmentCam
                width: body.width
                label: qsTr("Segments")
                value: Editor.cam.segments.count
                onClicked: inputs.segmentsRequested()
            }
            Repeater {
                model: inputs.visible ? Editor.choices : null
                SettingRow {
                    required property int index
                    required property string name
                    required property string valueText
                    required property list<string> options
                    required property int option
                    objectName: "choice" + index
                    width: body.width
                    label: name
                    value: valueText
                    onClicked: inputs.choiceRequested(index, name, options, option)
                }
            }
            Grid {
                id: grid
                width: body.width
                columns: inputs.columns
                spacing: Theme.size.spacing

                Repeater {
                    model: inputs.visible ? Editor.fields : []
                    FieldTile {
                        required property var modelData
                        objectName: "field_" + field.fieldId
                        field: modelData as EditorField
                        compact: inputs.columns > 1
                        width: inputs.cell
                        height: Theme.size.touch
                        onEditRequested: (field, source) => inputs.editRequested([field], 0, source)
                        onExplainRequested: field => inputs.explainRequested(field)
                    }
                }
            }
        }
    }
    ScrollMark { view: list }
    Button {
        id: moreButton
        objectName: "more"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        glyph: Theme.icon.more
        text: qsTr("View and tools")
        onClicked: inputs.moreRequested()
    }
}
