// SPDX-License-Identifier: Apache-2.0
// The numbers of the machine, each with its explanation.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

FirstStep {
    id: step

    readonly property real rowHeight: Math.round(1.15 * Theme.size.touch)

    ListView {
        id: list
        objectName: "firstMachine"
        anchors.fill: parent
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.machineFields
        delegate: Item {
            id: row
            required property var modelData
            width: list.width - 2 * Theme.size.accent
            height: step.rowHeight
            FieldTile {
                id: tile
                objectName: "first_" + field.fieldId
                field: row.modelData as EditorField
                compact: false
                width: parent.width * 0.42
                height: parent.height
                onEditRequested: (field, source) => step.page.editRequested([field], 0, source)
                onExplainRequested: field => step.page.explainRequested(field)
            }
            Label {
                anchors { left: tile.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top; bottom: parent.bottom }
                verticalAlignment: Text.AlignVCenter
                wrapMode: Text.WordWrap
                fontSizeMode: Text.Fit
                minimumPixelSize: Theme.size.caption - 3
                text: tile.field.explanation
                color: Theme.color.secondaryInk
            }
        }
    }
    ScrollMark { view: list }
}
