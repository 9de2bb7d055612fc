// SPDX-License-Identifier: Apache-2.0
// The order of a packing machine on Run: how many bags are made and rejected, and when it ends. Without an order it is the
// key for a new one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: strip

    readonly property bool shows: Orders.current.underWay || Orders.current.complete
    readonly property color figureInk: Orders.fresh || Orders.current.complete ? Theme.color.ink : Theme.color.disabledInk
    readonly property color noteInk: Orders.fresh || Orders.current.complete ? Theme.color.secondaryInk : Theme.color.disabledInk

    // A title, a number that is read from a distance, and the bar.
    readonly property int numberSize: Math.round(1.3 * Theme.size.value)
    implicitHeight: Math.max(Theme.size.touch, Math.round(1.5 * Theme.size.caption + 1.45 * strip.numberSize) + Theme.size.spacing)

    component Count: Column {
        id: count
        required property string title
        required property string text
        visible: count.text.length > 0
        anchors.verticalCenter: parent?.verticalCenter
        width: Math.max(word.implicitWidth, number.implicitWidth)
        Label {
            id: word
            text: count.title
            color: strip.noteInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            id: number
            text: count.text
            color: strip.figureInk
            font { pixelSize: Theme.size.value; weight: Font.DemiBold }
        }
    }

    TouchButton {
        id: key
        objectName: "orderStrip"
        anchors.fill: parent
        visible: strip.shows
        Accessible.name: qsTr("Order")
        detail: Theme.fill(qsTr("%1: %2"), [Orders.current.title, Orders.current.progress])
        background: Card { color: key.down ? Theme.color.touchTint : Theme.color.surface }
        onClicked: Frame.open("Orders/OrdersSheet", {})

        Label {
            id: title
            objectName: "orderTitle"
            anchors { left: parent.left; leftMargin: Theme.size.padding; right: counts.left; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.accent }
            fontSizeMode: Text.HorizontalFit
            text: Orders.current.complete ? Theme.fill(qsTr("%1 · %2"), [Orders.current.title, Orders.current.stateText]) : Orders.current.title
            color: strip.noteInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            objectName: "orderProgress"
            anchors { left: title.left; right: title.right; top: title.bottom; bottom: bar.top }
            fontSizeMode: Text.Fit
            text: Orders.current.progress
            color: strip.figureInk
            font { pixelSize: strip.numberSize; bold: true }
        }
        ProgressBar {
            id: bar
            anchors { left: title.left; right: title.right; bottom: parent.bottom; bottomMargin: Theme.size.accent }
            height: Theme.size.spacing
            progress: Orders.current.fraction
        }
        Row {
            id: counts
            anchors { right: arrow.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.padding
            Count { objectName: "orderEndTime"; title: qsTr("ends"); text: Orders.endText }
            Count { objectName: "orderRejected"; title: qsTr("rejected"); text: Theme.count(Orders.current.rejected, 0) }
            Count { objectName: "orderEmpty"; title: qsTr("empty"); text: Theme.count(Orders.current.empty, 0) }
        }
        IconLabel {
            id: arrow
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            code: Theme.icon.next
            color: Theme.color.touch
            font.pixelSize: Theme.size.body
        }
    }
    Button {
        readonly property bool waits: Orders.offers.titles.length > 0 || Orders.queue.count > 0

        objectName: "newOrder"
        anchors.fill: parent
        visible: !strip.shows && Orders.tooOldText.length === 0
        level: waits ? Access.Viewer : Access.Operator
        text: Orders.offers.titles.length > 0 ? Theme.fill(qsTr("Offered by the plant: %1"), [Orders.offers.titles]) : Orders.queue.count > 0 ? qsTr("Orders that wait: %1").arg(Orders.queue.count) : qsTr("New order")
        onClicked: {
            if (waits)
                Frame.open("Orders/OrdersSheet", {})
            else if (Access.ask(Access.Operator))
                Frame.open("Orders/NewOrderSheet", { fresh: true })
        }
    }
    Label {
        objectName: "orderTooOld"
        anchors.fill: parent
        visible: !strip.shows && Orders.tooOldText.length > 0
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.WordWrap
        text: Orders.tooOldText
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
