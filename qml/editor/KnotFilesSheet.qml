// SPDX-License-Identifier: Apache-2.0
// Import and export of knots as CSV files.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Parts

OfferSheet {
    id: sheet

    property bool exports
    signal knotsTaken()

    title: qsTr("Knots as CSV")
    exchange: Editor.cam.knotFiles
    offers: exports ? Editor.cam.knotFiles.places : Editor.cam.knotFiles.files
    chooseText: exports ? qsTr("Choose the location of the new file.") : qsTr("Choose a file to view its content.")
    emptyText: qsTr("There is no CSV file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.").arg(Editor.cam.knotFiles.ownFolder)
    actionText: exports ? qsTr("Write file") : qsTr("Import")
    headHeight: way.height + Theme.size.spacing
    Component.onCompleted: Editor.cam.knotFiles.scan()
    onAccepted: row => {
        if (sheet.exports) {
            Editor.cam.knotFiles.write(row)
        } else {
            Editor.cam.knotFiles.take(row)
            sheet.knotsTaken()
        }
    }

    Segmented {
        id: way
        objectName: "knotFilesWay"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        choices: [{ key: false, text: qsTr("Import CSV"), name: "knotsImport" }, { key: true, text: qsTr("Export CSV"), name: "knotsExport" }]
        current: sheet.exports
        onChosen: key => {
            sheet.exports = key
            sheet.chosen = -1
            Editor.cam.knotFiles.scan()
        }
    }
}
