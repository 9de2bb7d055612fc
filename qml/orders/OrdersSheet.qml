// SPDX-License-Identifier: Apache-2.0
// The order that the controller counts, those that wait, and those that were started.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    property bool showsHistory

    objectName: "ordersSheet"
    title: qsTr("Orders")
    note: Orders.message
    Component.onCompleted: {
        Orders.setWatchedBy(sheet, true)
        Orders.history.watched = true
    }
    Component.onDestruction: {
        Orders.setWatchedBy(sheet, false)
        Orders.history.watched = false
    }

    CurrentOrder {
        id: current
        anchors { left: parent.left; right: parent.right; top: parent.top }
        visible: Orders.current.present && !sheet.showsHistory
    }
    Item {
        anchors { left: parent.left; right: parent.right; top: current.visible ? current.bottom : parent.top; bottom: parent.bottom; topMargin: current.visible ? Theme.size.spacing : 0 }
        visible: !sheet.showsHistory
        Label {
            objectName: "queueEmpty"
            anchors.centerIn: parent
            visible: Orders.queue.count === 0 && Orders.offers.rows.count === 0
            text: qsTr("No order waits.")
            color: Theme.color.secondaryInk
        }
        ListView {
            id: offered
            objectName: "offeredList"
            anchors { left: parent.left; right: parent.right; top: parent.top }
            height: Math.min(contentHeight, parent.height / 2)
            clip: true
            spacing: Theme.size.outline
            boundsBehavior: Flickable.StopAtBounds
            model: Orders.offers.rows
            delegate: OfferedRow {}
        }
        ScrollMark { view: offered }
        ListView {
            id: list
            objectName: "queueList"
            anchors { left: parent.left; right: parent.right; top: offered.bottom; bottom: parent.bottom; topMargin: offered.count > 0 ? Theme.size.outline : 0 }
            clip: true
            spacing: Theme.size.outline
            boundsBehavior: Flickable.StopAtBounds
            model: Orders.queue
            delegate: QueueRow {
                objectName: "queue" + index
                onRemoveRequested: Orders.remove(index)
            }
        }
        ScrollMark { view: list }
    }
    OrderList {
        anchors.fill: parent
        visible: sheet.showsHistory
    }
    footer: [
        Button {
            objectName: "ordersFilter"
            visible: sheet.showsHistory
            glyph: Theme.icon.filter
            text: qsTr("Filter")
            onClicked: Frame.open("Orders/OrderFilterSheet", {})
        },
        Button {
            objectName: "ordersCsv"
            visible: sheet.showsHistory
            level: Access.Operator
            glyph: Theme.icon.save
            text: qsTr("CSV")
            enabled: Orders.history.rows.count > 0 && !Orders.history.csv.busy
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                Orders.history.csv.make(Maintenance.files)
                Frame.open("Parts/ReportFilesSheet", { title: qsTr("Orders as CSV"), note: Orders.history.filter.summary })
            }
        },
        Button {
            objectName: "orderStops"
            visible: Orders.current.present && !sheet.showsHistory
            text: qsTr("Stops and OEE")
            onClicked: {
                Stops.shift.showOrder(Orders.current.title, Orders.current.startedMs, Orders.current.endedMs)
                Frame.openPage("stops")
            }
        },
        Button {
            objectName: "orderRecipe"
            visible: Orders.wantedRecipe.length > 0 && !sheet.showsHistory
            level: Access.Operator
            text: Theme.fill(qsTr("Open %1"), [Orders.wantedRecipe])
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                // Edits would be lost: the page of the recipes asks.
                if (!Recipes.chooseNamed(Orders.wantedRecipe) || Editor.edited) {
                    Frame.openPage("recipes")
                    return
                }
                Recipes.open()
                Frame.open("Download/DownloadSheet", {})
            }
        },
        Button {
            objectName: "ordersHistory"
            text: sheet.showsHistory ? qsTr("Back") : qsTr("History")
            onClicked: sheet.showsHistory = !sheet.showsHistory
        },
        Button {
            objectName: "ordersNew"
            visible: !sheet.showsHistory
            level: Access.Operator
            kind: Button.Primary
            text: qsTr("New order")
            onClicked: if (Access.ask(Access.Operator)) Frame.open("Orders/NewOrderSheet", { fresh: true })
        }
    ]
}
