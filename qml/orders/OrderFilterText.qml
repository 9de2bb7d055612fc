// SPDX-License-Identifier: Apache-2.0
// A text of the filter of orders, typed. Then the filter is there again.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    id: sheet

    required property string member        // of the filter

    text: Orders.history.filter[sheet.member]
    onAccepted: text => Orders.history.filter[sheet.member] = text
    onClosed: Frame.open("Orders/OrderFilterSheet", {})
}
