// SPDX-License-Identifier: Apache-2.0
// The numbers of the machine beside its drawing, which marks the chosen one and explains it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: step

    property int chosen
    readonly property EditorField field: Editor.machineFields[chosen] as EditorField
    readonly property bool narrow: width < 5 * Theme.size.touch // beside the keypad
    readonly property real rowHeight: Math.round(1.15 * Theme.size.touch)

    ListView {
        id: list
        objectName: "firstMachine"
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        width: parent.width * (step.narrow ? 1 : 0.45)
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.machineFields
        delegate: FieldTile {
            required property int index
            required property var modelData
            objectName: "first_" + item.fieldId
            item: modelData as EditorField
            compact: false
            width: list.width - scrollMark.room
            height: step.rowHeight
            onClicked: step.chosen = index
        }
    }
    ScrollMark {
        id: scrollMark
        view: list
        x: list.width - width
    }
    MachineDrawing {
        id: drawing
        anchors { left: list.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top }
        height: parent.height * 0.58
        visible: !step.narrow
        fieldId: step.field?.fieldId ?? ""
    }
    Label {
        anchors { left: drawing.left; right: drawing.right; top: drawing.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom }
        visible: !step.narrow
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: step.field?.explanation ?? ""
        color: Theme.color.secondaryInk
    }
}
