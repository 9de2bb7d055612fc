// SPDX-License-Identifier: Apache-2.0
// The segments of a cam: the list at the left, motion and numbers of the selected one at the right, tools below.
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
    signal motionRequested()
    signal filesRequested()

    title: qsTr("Segments")
    note: Editor.cam.segments.jointText
    panelWidth: width * 0.94

    ListView {
        id: list
        objectName: "segmentList"
        anchors { left: parent.left; top: parent.top; bottom: tools.top; bottomMargin: Theme.size.spacing }
        width: Math.round(parent.width * 0.46)
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.cam.segments.rows
        delegate: T.AbstractButton {
            id: entry
            Accessible.role: Accessible.Button
            Accessible.name: qsTr("Segment %1").arg(entry.number)
            required property int index
            required property int number
            required property string rangeText
            required property string motionText
            required property string endText
            required property bool jumps
            required property bool selected
            objectName: "segment" + index
            width: list.width - 2 * Theme.size.accent
            height: Theme.size.touch
            onClicked: Editor.cam.segments.selected = index
            background: Rectangle {
                radius: Theme.size.radius
                color: entry.selected || entry.down ? Theme.color.touchTint : Theme.color.surface
                border { width: entry.selected ? Theme.size.hairline : 0; color: Theme.color.touch }
            }
            Column {
                anchors { left: parent.left; right: parent.right; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
                Item {
                    width: parent.width
                    height: range.height
                    Label {
                        id: range
                        anchors { left: parent.left; right: end.left }
                        text: entry.number + "  " + entry.rangeText
                        fontSizeMode: Text.HorizontalFit
                        minimumPixelSize: Theme.size.caption - 3
                        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
                    }
                    Label {
                        id: end
                        anchors.right: parent.right
                        text: entry.endText
                        font.pixelSize: Theme.size.caption
                    }
                }
                Label {
                    width: parent.width
                    text: entry.jumps ? qsTr("%1 · jump at the start").arg(entry.motionText) : entry.motionText
                    fontSizeMode: Text.HorizontalFit
                    minimumPixelSize: Theme.size.caption - 3
                    color: entry.jumps ? Theme.color.warning : Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
        }
    }
    ScrollMark { view: list }
    Flickable {
        id: numbers
        objectName: "segmentNumbers"
        anchors { left: list.right; leftMargin: Theme.size.gap; right: parent.right; top: parent.top; bottom: list.bottom }
        contentHeight: column.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Column {
            id: column
            width: parent.width - 2 * Theme.size.accent
            spacing: Theme.size.spacing

            SettingRow {
                objectName: "segmentMotion"
                width: column.width
                label: qsTr("Motion")
                value: Editor.cam.segments.motionName
                onClicked: sheet.motionRequested()
            }
            Grid {
                id: grid
                width: column.width
                columns: 2
                spacing: Theme.size.spacing
                Repeater {
                    model: Editor.cam.segments.fields
                    FieldTile {
                        required property var modelData
                        objectName: "field_" + field.fieldId
                        field: modelData as EditorField
                        compact: false
                        width: (grid.width - grid.spacing) / 2
                        height: Theme.size.touch
                        onEditRequested: (field, source) => sheet.editRequested([field], 0, source)
                    }
                }
            }
        }
    }
    ScrollMark { view: numbers }
    Row {
        id: tools
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        readonly property real part: (width - 4 * spacing) / 5
        Button {
            objectName: "segmentAdd"
            width: tools.part
            height: tools.height
            text: qsTr("Add dwell")
            enabled: Editor.cam.segments.canDivide
            onClicked: Editor.cam.segments.addDwell()
        }
        Button {
            objectName: "segmentSplit"
            width: tools.part
            height: tools.height
            text: qsTr("Split")
            enabled: Editor.cam.segments.canDivide
            onClicked: Editor.cam.segments.split()
        }
        Button {
            objectName: "segmentRemove"
            width: tools.part
            height: tools.height
            text: qsTr("Remove")
            enabled: Editor.cam.segments.canRemove
            onClicked: Editor.cam.segments.removeSelected()
        }
        Button {
            objectName: "segmentRepair"
            width: tools.part
            height: tools.height
            text: qsTr("Make continuous")
            enabled: Editor.cam.segments.canRepair
            onClicked: Editor.cam.segments.repair()
        }
        Button {
            objectName: "segmentFilesButton"
            width: tools.part
            height: tools.height
            text: qsTr("CSV files")
            onClicked: sheet.filesRequested()
        }
    }
}
