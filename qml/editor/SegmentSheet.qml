// SPDX-License-Identifier: Apache-2.0
// The segments of a cam beside its curve.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

CamSheet {
    id: sheet

    handles: Editor.cam.segments
    remark: Editor.cam.segments.jointText

    list.objectName: "segmentList"
    list.model: Editor.cam.segments.rows
    list.delegate: CamRow {
        required property int index
        required property string rangeText
        required property string motionText
        required property bool jumps
        objectName: "segment" + index
        text: qsTr("Segment %1").arg(number)
        place: rangeText
        note: jumps ? qsTr("%1 · jump at the start").arg(motionText) : motionText
        warns: jumps
        onClicked: sheet.handles.selected = index
    }
    SettingRow {
        objectName: "segmentMotion"
        width: parent?.width ?? 0
        label: qsTr("Motion")
        value: Editor.cam.segments.motionName
        onClicked: Frame.open("Editor/SegmentMotionSheet", {})
    }
    Repeater {
        model: Editor.cam.segments.fields
        FieldTile {
            required property var modelData
            item: modelData as EditorField
            compact: false
            width: parent?.width ?? 0
        }
    }
    tools: [
        Button {
            objectName: "segmentAdd"
            level: Access.Technician
            width: sheet.toolWidth(3, false)
            text: qsTr("Add dwell")
            enabled: Editor.cam.segments.canDivide
            onClicked: Editor.cam.segments.addDwell()
        },
        Button {
            objectName: "segmentSplit"
            level: Access.Technician
            width: sheet.toolWidth(3, false)
            text: qsTr("Split")
            enabled: Editor.cam.segments.canDivide
            onClicked: Editor.cam.segments.split()
        },
        Button {
            objectName: "segmentRemove"
            level: Access.Technician
            width: sheet.toolWidth(3, true)
            text: qsTr("Remove")
            enabled: Editor.cam.segments.canRemove
            onClicked: Editor.cam.segments.removeSelected()
        },
        Button {
            objectName: "segmentRepair"
            level: Access.Technician
            width: sheet.toolWidth(2, false)
            text: qsTr("Make continuous")
            enabled: Editor.cam.segments.canRepair
            onClicked: Editor.cam.segments.repair()
        },
        Button {
            objectName: "segmentFilesButton"
            width: sheet.toolWidth(2, true)
            text: qsTr("CSV files")
            onClicked: Frame.open("Editor/CamFilesSheet", {})
        }
    ]
}
