// SPDX-License-Identifier: Apache-2.0
// A text of the new order, typed or scanned. Then the form is there again.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    id: sheet

    required property string member        // of Orders.entry

    text: Orders.entry[sheet.member]
    level: Access.Operator
    holds: Orders.entry.touched
    check: text => sheet.member === "lot" ? Orders.entry.lotProblem(text) : Orders.entry.textProblem(text)
    onAccepted: text => Orders.entry[sheet.member] = text
    onClosed: Frame.open("Orders/NewOrderSheet", {})

    Connections {
        target: Scan
        function onCodeRead(code: string) { sheet.fill(code) }
    }
    QtObject {
        Component.onCompleted: Scan.beginEntry()
        Component.onDestruction: Scan.endEntry()
    }
}
