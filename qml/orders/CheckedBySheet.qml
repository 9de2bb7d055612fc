// SPDX-License-Identifier: Apache-2.0
// The person who has checked the first bag of the order under way.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    title: qsTr("First bag checked by")
    text: Orders.current.checkedBy.length > 0 ? Orders.current.checkedBy : Access.userName
    level: Access.Operator
    check: text => Orders.entry.textProblem(text)
    onAccepted: text => Orders.setCheckedBy(text)
    onClosed: Frame.open("Orders/OrdersSheet", {})
}
