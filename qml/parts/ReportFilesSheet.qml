// SPDX-License-Identifier: Apache-2.0
// The place for a report: a USB stick or the panel's own folder.
import QtQuick
import CamPanel.Panel

OfferSheet {
    id: sheet

    property ReportFiles files: Maintenance.files

    level: Access.Operator

    exchange: files
    offers: files.places
    chooseText: qsTr("Choose the location of the new files.")
    actionText: qsTr("Write file")
    workText: qsTr("Writing …")
    onAccepted: row => sheet.files.write(row)
}
