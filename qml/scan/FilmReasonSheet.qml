// SPDX-License-Identifier: Apache-2.0
// The reason for running with another film reel, for the audit trail.
pragma ComponentBehavior: Bound
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    id: sheet

    property string reason

    title: qsTr("Why is another film reel used?")
    problem: reason.trim().length === 0 ? qsTr("Enter the reason for the audit trail.") : ""
    onEdited: text => sheet.reason = text
    onAccepted: {
        Scan.film.overrideCheck(sheet.reason)
        closed()
    }
}
