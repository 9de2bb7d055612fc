// SPDX-License-Identifier: Apache-2.0
// The order of a packing machine on Run: how many bags are made, when it ends, and what they were. Without an order it is the
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

    // Two lines of text, also Chinese ones, on screens that are read from a distance.
    implicitHeight: Math.max(Theme.size.touch, Math.round(1.7 * (Theme.size.caption + Theme.size.value)))

    component Count: Column {
        id: count
        required property string title
        required property double bags
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
            text: Theme.count(count.bags, 0)
            color: strip.figureInk
            font { pixelSize: Theme.size.title; weight: Font.DemiBold }
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

        Column {
            id: words
            anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            width: Math.round(parent.width * 0.4)
            Label {
                objectName: "orderTitle"
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: Orders.current.title
                color: strip.noteInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                objectName: "orderProgress"
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                readonly property string more: Orders.current.complete ? Orders.current.stateText : Orders.endText
                text: more.length > 0 ? Orders.current.progress + " · " + more : Orders.current.progress
                color: strip.figureInk
                font { pixelSize: Theme.size.value; weight: Font.DemiBold }
            }
        }
        ProgressBar {
            anchors { left: words.right; leftMargin: Theme.size.padding; right: counts.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            progress: Orders.current.fraction
        }
        Row {
            id: counts
            anchors { right: arrow.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.padding
            Count { objectName: "orderGood"; title: qsTr("good"); bags: Orders.current.good }
            Count { objectName: "orderRejected"; title: qsTr("rejected"); bags: Orders.current.rejected }
            Count { objectName: "orderEmpty"; title: qsTr("empty"); bags: Orders.current.empty }
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
        objectName: "newOrder"
        anchors.fill: parent
        visible: !strip.shows && Orders.tooOldText.length === 0
        level: Orders.queue.count > 0 ? Access.Viewer : Access.Operator
        text: Orders.queue.count > 0 ? qsTr("Orders that wait: %1").arg(Orders.queue.count) : qsTr("New order")
        onClicked: {
            if (Orders.queue.count > 0)
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
