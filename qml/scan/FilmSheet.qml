// SPDX-License-Identifier: Apache-2.0
// A wrong film reel: both codes, and the override for a technician, who gives a reason.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

ConfirmSheet {
    id: sheet

    title: qsTr("Start is blocked")
    question: Scan.film.blockedReason
    ways: [{ key: "override", text: qsTr("Override …"), primary: false, level: Access.Technician }]
    onChosen: if (Access.ask(Access.Technician)) Frame.open("Scan/FilmReasonSheet", {})

    Connections {
        target: Scan.film
        function onChanged() {
            if (Scan.film.blockedReason.length === 0)
                sheet.closed()
        }
    }
}
