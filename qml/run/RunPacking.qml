// SPDX-License-Identifier: Apache-2.0
// Run of a packing machine, in the order in which an operator looks: the order, rate and bag length in digits for three metres,
// the film as a picture, then what is asked for less often.
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
    readonly property real numbersTop: order.visible ? order.height + gap : 0
    readonly property real bannerRow: tiles.height   // a banner covers the lowest cards: nothing else moves

    readonly property var knifeFaults: ["C-01", "C-03", "C-08", "C-09"]
    readonly property bool showsFault: Controller.faulted && Controller.fresh && Alarms.urgent.code.startsWith("C-")

    OrderStrip {
        id: order
        anchors { left: parent.left; right: parent.right }
        visible: Orders.offered
    }
    RateCard {
        id: rate
        visible: !view.showsFault
        y: view.numbersTop
        width: Math.round(Math.max(naturalWidth, 0.36 * (view.width - view.gap)))
        height: Math.round(Math.min(implicitHeight, 0.45 * (view.height - view.numbersTop)))
    }
    LengthCard {
        visible: rate.visible
        anchors { left: rate.right; leftMargin: view.gap; right: parent.right; top: rate.top; bottom: rate.bottom }
    }
    // In the place of the numbers, which say nothing while the machine stands.
    Loader {
        anchors { left: parent.left; right: parent.right; top: rate.top; bottom: rate.bottom }
        active: view.showsFault
        source: "FaultCard.qml"
    }
    FilmCard {
        id: film
        faultAtKnife: view.showsFault && view.knifeFaults.includes(Alarms.urgent.code)
        anchors { left: parent.left; right: parent.right; top: rate.bottom; topMargin: view.gap; bottom: tiles.top; bottomMargin: view.gap }
    }
    Row {
        id: tiles
        readonly property int tileWidth: (width - (HandTrims.present ? handKey.width + spacing : 0) - 2 * spacing) / 3
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Math.max(Theme.size.touch, Math.round(0.42 * (view.height - rate.y - rate.height - 2 * view.gap)))
        visible: view.bottomInset === 0
        spacing: view.gap
        // At the left: no key of a banner, which takes this place, is where it is.
        Button {
            id: handKey
            objectName: "trimKey"
            width: Math.round(1.5 * Theme.size.touch)
            height: tiles.height
            visible: HandTrims.present
            enabled: HandTrims.offered
            text: qsTr("By hand")
            note: HandTrims.unsaved ? qsTr("not saved") : HandTrims.moved ? qsTr("moved") : ""
            Accessible.description: qsTr("Cut, product and length")
            onClicked: Frame.open("Run/TrimSheet", {})
        }
        KnifeCard { width: tiles.tileWidth; height: tiles.height }
        SkippedCutsCard { width: tiles.tileWidth; height: tiles.height }
        LastStopCard { width: tiles.width - x; height: tiles.height }
    }
    Binding {
        target: HandTrims
        property: "watched"
        value: view.visible && !Display.dark
    }
}
