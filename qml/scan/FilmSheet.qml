// SPDX-License-Identifier: Apache-2.0
// A wrong film reel: both codes, and the override for a technician, who gives a reason.
pragma ComponentBehavior: Bound
import CamPanel.Parts
import CamPanel.Panel

ConfirmSheet {
    signal reasonRequested()

    title: qsTr("Start is blocked")
    question: Scan.film.blockedReason
    ways: [{ key: "override", text: qsTr("Override …"), primary: false }]
    onChosen: if (Access.ask(Access.Technician)) reasonRequested()
}
