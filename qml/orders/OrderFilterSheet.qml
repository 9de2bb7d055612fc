// SPDX-License-Identifier: Apache-2.0
// The filter of the orders that were started. Then their list is there again.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

LogFilterSheet {
    id: sheet

    filter: Orders.history.filter
    idLabel: qsTr("Order, lot or number")
    onIdRequested: Frame.open("Orders/OrderFilterText", { member: "id", title: sheet.idLabel })
    onWordRequested: Frame.open("Orders/OrderFilterText", { member: "word", title: qsTr("Word") })
    onClosed: Frame.open("Orders/OrdersSheet", { showsHistory: true })
}
