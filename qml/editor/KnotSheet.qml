// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam beside its curve.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

CamSheet {
    id: sheet

    handles: Editor.cam.knots
    remark: Editor.cam.knots.wrapText

    list.objectName: "knotList"
    list.model: Editor.cam.knots.rows
    list.delegate: CamRow {
        required property int index
        required property string masterText
        required property string slaveText
        objectName: "knot" + index
        text: qsTr("Knot %1").arg(number)
        place: masterText + "°"
        note: Theme.joined(slaveText, Theme.shownUnit("mm"))
        onClicked: sheet.handles.selected = index
    }
    Repeater {
        model: [Editor.cam.knots.master, Editor.cam.knots.slave]
        FieldTile {
            required property var modelData
            item: modelData as EditorField
            compact: false
            enabled: item.maximum > item.minimum
            width: parent?.width ?? 0
            height: Theme.size.touch + 2 * Theme.size.spacing  // its label may need two lines
        }
    }
    tools: [
        Button {
            objectName: "knotInsert"
            level: Access.Technician
            width: sheet.toolWidth(2, false)
            text: qsTr("Add after")
            onClicked: Editor.cam.knots.insertAfterSelected()
        },
        Button {
            objectName: "knotRemove"
            level: Access.Technician
            width: sheet.toolWidth(2, true)
            text: qsTr("Remove")
            enabled: Editor.cam.knots.canRemove
            onClicked: Editor.cam.knots.removeSelected()
        },
        Button {
            objectName: "knotRepair"
            level: Access.Technician
            width: sheet.toolWidth(2, false)
            text: qsTr("Close smoothly")
            enabled: Editor.cam.knots.canRepair
            onClicked: Editor.cam.knots.repairWrap()
        },
        Button {
            objectName: "knotFilesButton"
            width: sheet.toolWidth(2, true)
            text: qsTr("CSV files")
            onClicked: Frame.open("Editor/CamFilesSheet", {})
        }
    ]
}
