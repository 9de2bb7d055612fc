// SPDX-License-Identifier: Apache-2.0
// Import and export of the knots or segments of a cam as CSV files.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Parts

OfferSheet {
    id: sheet

    property bool exports

    title: Editor.kind === Editor.Kind.SegmentCam ? qsTr("Segments as CSV") : qsTr("Knots as CSV")
    exchange: Editor.cam.files
    level: exports ? Access.Operator : Access.Technician
    offers: exports ? Editor.cam.files.places : Editor.cam.files.files
    chooseText: exports ? qsTr("Choose the location of the new file.") : qsTr("Choose a file to view its content.")
    emptyText: qsTr("There is no CSV file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.").arg(Editor.cam.files.ownFolder)
    actionText: exports ? qsTr("Write file") : qsTr("Import")
    workText: qsTr("Writing …")
    headHeight: way.height + Theme.size.spacing
    Component.onCompleted: Editor.cam.files.scan()
    onAccepted: row => {
        if (sheet.exports) {
            Editor.cam.files.write(row)
        } else {
            Editor.cam.files.take(row)
            Frame.open(Editor.kind === Editor.Kind.SegmentCam ? "Editor/SegmentSheet" : "Editor/KnotSheet", {})
        }
    }

    Segmented {
        id: way
        objectName: "camFilesWay"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        choices: [{ key: false, text: qsTr("Import CSV"), name: "listImport" }, { key: true, text: qsTr("Export CSV"), name: "listExport" }]
        current: sheet.exports
        onChosen: key => {
            sheet.exports = key
            sheet.chosen = -1
            Editor.cam.files.scan()
        }
    }
}
