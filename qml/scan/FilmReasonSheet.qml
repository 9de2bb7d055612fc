// SPDX-License-Identifier: Apache-2.0
// The reason for running with another film reel, for the audit trail.
pragma ComponentBehavior: Bound
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    title: qsTr("Why is another film reel used?")
    level: Access.Technician
    check: text => text.trim().length === 0 ? qsTr("Enter the reason for the audit trail.") : ""
    onAccepted: text => Scan.film.overrideCheck(text)
}
