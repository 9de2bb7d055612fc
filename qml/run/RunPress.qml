// SPDX-License-Identifier: Apache-2.0
// Run of a press: present force and position, the stage, the newest stroke as a curve and the earlier strokes.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: view

    readonly property int gap: Theme.size.gap
    property real bottomInset
    readonly property real upper: Math.round((height - gap) * 0.26)
    readonly property real cell: (width - 2 * gap) / 3

    NumberCard {
        id: force
        objectName: "pressForce"
        width: view.cell
        height: view.upper
        value: Controller.live.forceN
        decimals: 0
        title: qsTr("Force")
        unit: "N"
    }
    NumberCard {
        id: position
        objectName: "pressPosition"
        anchors { left: force.right; leftMargin: view.gap }
        width: view.cell
        height: view.upper
        value: Controller.live.positionMm
        decimals: 2
        title: qsTr("Position")
        unit: "mm"
    }
    NumberCard {
        objectName: "goodStrokes"
        anchors { left: position.right; leftMargin: view.gap; right: parent.right }
        height: view.upper
        text: Controller.strokes.rows.count > 0 ? Theme.count(Controller.strokes.goodCount, 0) + " / " + Theme.count(Controller.strokes.rows.count, 0) : Theme.unknownText
        title: qsTr("Good / last strokes")
        quantities: [Explanations.GoodStrokes]
    }
    StageStrip {
        id: stages
        anchors { left: parent.left; right: parent.right; top: force.bottom; topMargin: view.gap }
        height: Theme.size.value + Theme.size.padding
    }
    ForceCard {
        id: curve
        anchors { left: parent.left; top: stages.bottom; topMargin: view.gap; bottom: parent.bottom; bottomMargin: view.bottomInset }
        width: Math.round((view.width - view.gap) * 0.6)
    }
    StrokeCard {
        anchors { left: curve.right; leftMargin: view.gap; right: parent.right; top: curve.top; bottom: curve.bottom }
    }
}
