// SPDX-License-Identifier: Apache-2.0
// The reason for values outside their approved windows: one of a short list, or a typed one. Another sheet may hold this one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

ListPicker {
    id: sheet

    readonly property WindowReason reasons: Editor.programDownload.windowReason

    function give(text: string): void {
        sheet.reasons.give(text)
        sheet.closed()
    }

    title: qsTr("Why outside the approved window?")
    note: qsTr("The reason is shown until the machine runs within the window again, and kept in the audit trail.")
    panelWidth: Math.round(width * 0.8)
    level: Access.Operator
    stays: true
    covered: typing.active
    current: ""
    choices: [
        { key: "material", text: qsTr("Film or product differs") },
        { key: "line", text: qsTr("Adapted to the line before or after") },
        { key: "trial", text: qsTr("Trial, approved by word") },
        { key: "other", text: qsTr("Another reason …") }
    ]
    onChosen: key => {
        if (!Access.ask(Access.Operator))
            return
        if (key === "other")
            typing.active = true
        else
            sheet.give(sheet.choices.find(each => each.key === key)?.text ?? "")
    }

    SheetInPlace {
        id: typing
        below: sheet
        source: "WindowReasonText.qml"
    }
    Connections {
        target: typing.item
        function onAccepted(text: string) { sheet.give(text) }
    }
}
