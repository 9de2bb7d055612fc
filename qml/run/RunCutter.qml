// SPDX-License-Identifier: Apache-2.0
// Run of a rotary cutter: knife, rate, count, bag length, and the knife's speed over its target.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: view

    readonly property int gap: Theme.size.gap
    property real bottomInset
    readonly property real upper: Math.round((height - gap) * 0.48)

    DialCard {
        id: dial
        width: view.upper
        height: view.upper
    }
    NumberCard {
        id: rate
        anchors { left: dial.right; leftMargin: view.gap }
        width: Math.round((view.width - dial.width - 2 * view.gap) * 0.37)
        height: (view.upper - view.gap) / 2
        readonly property bool led: Controller.masterSetting.leads
        field: led ? "" : "rate_bags_per_min"
        value: Controller.live.rateBagsPerMin
        decimals: 1
        title: led ? qsTr("Rate of the line") : qsTr("Rate")
        unit: qsTr("bags/min")
        note: led ? Controller.masterSetting.lineText || qsTr("at most %1").arg(Theme.count(Controller.active.rateBagsPerMin, 1)) : isNaN(Controller.live.sealTimeMs) ? "" : qsTr("seal %1").arg(Theme.measure(Controller.live.sealTimeMs, 0, "ms"))
        quantities: isNaN(Controller.live.sealTimeMs) ? [Explanations.Rate] : [Explanations.Rate, Explanations.LiveSealTime]
        onTapped: Controller.masterSetting.explainRate()
    }
    NumberCard {
        anchors { left: rate.left; right: rate.right; top: rate.bottom; topMargin: view.gap }
        height: rate.height
        value: Controller.bags.count
        decimals: 0
        title: qsTr("Bags")
    }
    BagCard {
        anchors { left: rate.right; leftMargin: view.gap; right: parent.right }
        height: view.upper
    }
    SpeedCard {
        anchors { left: parent.left; right: parent.right; top: dial.bottom; topMargin: view.gap; bottom: parent.bottom; bottomMargin: view.bottomInset }
        title: qsTr("Knife speed %1").arg(Theme.shownUnit("mm/s"))
    }
}
