// SPDX-License-Identifier: Apache-2.0
// The question before an order ends early.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

ConfirmSheet {
    title: qsTr("End order")
    question: Theme.fill(qsTr("End %1 at %2 good bags? An ended order cannot be continued. The run goes on."), [Orders.current.title, Orders.current.progress])
    ways: [{ key: "end", text: qsTr("End order"), primary: true, level: Access.Operator }]
    onChosen: Orders.end()
    onClosed: Frame.open("Orders/OrdersSheet", {})
}
