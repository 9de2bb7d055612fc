// SPDX-License-Identifier: Apache-2.0
// Run of a move or a cam: speed, position, count, and the measured speed over its target; for a cam also its master,
// and where an encoder leads, what the line does.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: view

    readonly property int gap: Theme.size.gap
    property real bottomInset
    readonly property bool isCam: Controller.active.followsMaster
    readonly property real upper: Math.round((height - gap) * (isCam ? 0.4 : 0.28))
    readonly property real start: isCam ? dial.width + gap : 0
    readonly property real cell: isCam ? (width - start - gap) / 2 : (width - 2 * gap) / 3
    readonly property real row: isCam ? (upper - gap) / 2 : upper

    MasterDialCard {
        id: dial
        visible: view.isCam
        width: view.upper
        height: view.upper
    }
    NumberCard {
        objectName: "axisSpeed"
        x: view.start
        width: view.cell
        height: view.row
        value: Controller.live.knifeSpeedMmPerS
        decimals: 1
        title: qsTr("Speed")
        unit: "mm/s"
    }
    NumberCard {
        objectName: "axisPosition"
        x: view.start + view.cell + view.gap
        width: view.cell
        height: view.row
        value: Controller.live.positionMm
        decimals: 2
        title: Controller.direction.advanceText.length > 0 ? qsTr("Position (%1/cycle)").arg(Controller.direction.advanceText) : qsTr("Position")
        unit: "mm"
    }
    NumberCard {
        objectName: "axisCount"
        x: view.isCam ? view.start : 2 * (view.cell + view.gap)
        y: view.isCam ? view.row + view.gap : 0
        width: view.cell
        height: view.row
        value: Controller.live.cycleCount
        decimals: 0
        title: view.isCam ? qsTr("Cycles") : qsTr("Moves")
    }
    NumberCard {
        objectName: "masterSpeed"
        readonly property bool led: Controller.masterSetting.leads
        visible: view.isCam
        x: view.start + view.cell + view.gap
        y: view.row + view.gap
        width: view.cell
        height: view.row
        value: Controller.live.masterSpeedPercent
        decimals: 0
        title: qsTr("Master speed")
        unit: "%"
        note: led ? Controller.masterSetting.lineText : ""
        tappable: led
        onTapped: Controller.masterSetting.explainRate()
    }
    DirectionCard {
        id: direction
        visible: view.isCam
        y: view.upper + view.gap
        width: parent.width
    }
    SpeedCard {
        anchors { left: parent.left; right: parent.right; top: parent.top; topMargin: view.upper + view.gap + (view.isCam ? direction.height + view.gap : 0); bottom: parent.bottom; bottomMargin: view.bottomInset }
        title: qsTr("Axis speed %1").arg(Theme.shownUnit("mm/s"))
    }
}
