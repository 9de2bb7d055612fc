// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as a list: tap one to select it, its numbers and tools are below.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    signal editRequested(var fields, int index, Item source)
    signal filesRequested()

    title: qsTr("Knots")
    note: Editor.cam.knots.wrapText
    panelWidth: width * 0.86

    ListView {
        id: list
        objectName: "knotList"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: tiles.top; bottomMargin: Theme.size.spacing }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.cam.knots.rows
        delegate: T.AbstractButton {
            id: entry
            required property int index
            required property int number
            required property string masterText
            required property string slaveText
            required property bool selected
            objectName: "knot" + index
            width: list.width - 2 * Theme.size.accent
            height: Theme.size.touch
            onClicked: Editor.cam.knots.selected = index
            background: Rectangle {
                radius: Theme.size.radius
                color: entry.selected || entry.down ? Theme.color.touchTint : Theme.color.surface
                border { width: entry.selected ? Theme.size.hairline : 0; color: Theme.color.touch }
            }
            TableRow {
                anchors { fill: parent; topMargin: (parent.height - implicitHeight) / 2; bottomMargin: anchors.topMargin; rightMargin: Theme.size.padding }
                color: "transparent"
                cells: [entry.number, "", entry.masterText + "°", entry.slaveText + " mm"]
            }
        }
    }
    ScrollMark { view: list }
    Row {
        id: tiles
        anchors { left: parent.left; right: parent.right; bottom: tools.top; bottomMargin: Theme.size.spacing }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        Repeater {
            model: [Editor.cam.knots.master, Editor.cam.knots.slave]
            FieldTile {
                required property var modelData
                required property int index
                objectName: "field_" + field.fieldId
                field: modelData as EditorField
                compact: false
                enabled: field.maximum > field.minimum
                width: (tiles.width - tiles.spacing) / 2
                height: tiles.height
                onEditRequested: (field, source) => sheet.editRequested([field], 0, source)
            }
        }
    }
    Row {
        id: tools
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        readonly property real part: (width - 3 * spacing) / 4
        Button {
            objectName: "knotInsert"
            width: tools.part
            height: tools.height
            text: qsTr("Add after")
            onClicked: Editor.cam.knots.insertAfterSelected()
        }
        Button {
            objectName: "knotRemove"
            width: tools.part
            height: tools.height
            text: qsTr("Remove")
            enabled: Editor.cam.knots.canRemove
            onClicked: Editor.cam.knots.removeSelected()
        }
        Button {
            objectName: "knotRepair"
            width: tools.part
            height: tools.height
            text: qsTr("Close smoothly")
            enabled: Editor.cam.knots.canRepair
            onClicked: Editor.cam.knots.repairWrap()
        }
        Button {
            objectName: "knotFilesButton"
            width: tools.part
            height: tools.height
            text: qsTr("CSV files")
            onClicked: sheet.filesRequested()
        }
    }
}
