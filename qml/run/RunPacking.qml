// SPDX-License-Identifier: Apache-2.0
// Run of a packing machine: rate and bag length first, then the film as a picture, the knife's speed over its target and the
// skipped cuts.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: view

    readonly property int gap: Theme.size.gap
    property real bottomInset
    readonly property real room: height - 2 * gap - (order.visible ? order.height + gap : 0)
    readonly property real bannerRow: height - skippedCuts.y   // a banner covers the lowest cards: nothing else moves

    OrderStrip {
        id: order
        anchors { left: parent.left; right: parent.right }
        visible: Orders.offered
    }
    NumberCard {
        id: rate
        objectName: "packingRate"
        readonly property bool led: Controller.masterSetting.leads
        field: led ? "" : "rate_bags_per_min"
        y: order.visible ? order.height + view.gap : 0
        width: Math.round((view.width - view.gap) * 0.32)
        height: Math.round(view.room * 0.3)
        value: Controller.live.rateBagsPerMin
        decimals: 1
        title: led ? qsTr("Rate of the line") : HandSpeed.percent < 100 ? Theme.fill(qsTr("Rate, slowed to %1"), [Theme.joined(Theme.count(HandSpeed.percent, 0), "%")]) : qsTr("Rate")
        unit: qsTr("bags/min")
        // The seal time only where it fits; a long press explains it everywhere.
        note: led && Controller.masterSetting.lineText !== "" ? Controller.masterSetting.lineText : isNaN(Controller.live.sealTimeMs) || words.advanceWidth > width - 2 * Theme.size.padding ? qsTr("%1 bags").arg(Theme.count(Controller.bags.count, 0)) : words.text
        TextMetrics {
            id: words
            font.pixelSize: Theme.size.smallestText
            text: Theme.fill(qsTr("%1 bags · seal %2"), [Theme.count(Controller.bags.count, 0), Theme.measure(Controller.live.sealTimeMs, 0, "ms")])
        }
        quantities: isNaN(Controller.live.sealTimeMs) ? [Explanations.Rate] : [Explanations.Rate, Explanations.LiveSealTime]
        onTapped: Controller.masterSetting.explainRate()
    }
    BagStrip {
        anchors { left: rate.right; leftMargin: view.gap; right: parent.right; top: rate.top }
        height: rate.height
    }
    FilmCard {
        id: film
        anchors { left: parent.left; right: HandTrims.present ? trimKey.left : parent.right; rightMargin: HandTrims.present ? view.gap : 0; top: rate.bottom; topMargin: view.gap }
        height: Math.round(view.room * 0.36)
    }
    Button {
        id: trimKey
        objectName: "trimKey"
        anchors { right: parent.right; top: film.top; bottom: film.bottom }
        width: Math.round(1.5 * Theme.size.touch)
        visible: HandTrims.present
        enabled: HandTrims.offered
        text: qsTr("Trim")
        note: HandTrims.moved ? qsTr("moved") : ""
        Accessible.description: qsTr("Cut, product and length")
        onClicked: Frame.open("Run/TrimSheet", {})
    }
    Binding {
        target: HandTrims
        property: "watched"
        value: view.visible && !Display.dark
    }
    SpeedCard {
        visible: skippedCuts.visible
        anchors { left: parent.left; right: skippedCuts.left; rightMargin: view.gap; top: film.bottom; topMargin: view.gap; bottom: skippedCuts.bottom }
        compact: Theme.size.name === "small"
        title: qsTr("Knife speed %1").arg(Theme.shownUnit("mm/s"))
    }
    SkippedCutsCard {
        id: skippedCuts
        anchors { right: parent.right; top: film.bottom; topMargin: view.gap; bottom: parent.bottom }
        visible: view.bottomInset === 0
        width: Math.round((view.width - view.gap) * 0.36)
    }
}
