// SPDX-License-Identifier: Apache-2.0
// Import and export of knots as CSV files: on a USB stick or in the panel's own folder. The selected file is described below
// before the import.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property bool exports
    property int chosen: -1
    property string chosenDetail
    property bool chosenUsable
    signal knotsTaken()

    readonly property RowModel offers: exports ? Editor.knotFiles.places : Editor.knotFiles.files
    readonly property string hint: Editor.knotFiles.busy ? qsTr("Searching …")
        : offers.count === 0 ? qsTr("There is no CSV file on a USB stick or in %1. Plug a stick in and search again.").arg(Editor.knotFiles.ownFolder)
        : exports ? qsTr("Choose the location of the new file.") : qsTr("Choose a file to view its content.")

    function look(): void {
        sheet.chosen = -1
        Editor.knotFiles.look()
    }
    function goOn(): void {
        const row = sheet.chosen
        sheet.chosen = -1
        if (sheet.exports) {
            Editor.knotFiles.write(row)
        } else {
            Editor.knotFiles.take(row)
            sheet.knotsTaken()
        }
    }

    title: qsTr("Knots as CSV")
    Component.onCompleted: look()

    Segmented {
        id: way
        objectName: "knotFilesWay"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        choices: [{ key: false, text: qsTr("Import CSV"), name: "knotsImport" }, { key: true, text: qsTr("Export CSV"), name: "knotsExport" }]
        current: sheet.exports
        onChosen: key => {
            sheet.exports = key
            sheet.look()
        }
    }
    ListView {
        id: list
        objectName: "knotFiles"
        anchors { left: parent.left; right: parent.right; top: way.bottom; bottom: goOnButton.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.offers
        delegate: ChoiceRow {
            required property int index
            required property string title
            required property string detail
            required property bool usable
            required note
            objectName: "offer" + index
            width: list.width - 2 * Theme.size.accent
            text: title
            noteColor: usable || holds ? Theme.color.secondaryInk : Theme.color.fault
            holds: sheet.chosen === index
            onClicked: {
                sheet.chosen = index
                sheet.chosenDetail = detail
                sheet.chosenUsable = usable
            }
        }
    }
    ScrollMark { view: list }
    Label {
        objectName: "offerDetail"
        anchors { left: parent.left; right: lookButton.left; rightMargin: Theme.size.padding; top: goOnButton.top; bottom: parent.bottom }
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.size.caption - 2
        text: sheet.chosen >= 0 ? sheet.chosenDetail : Editor.knotFiles.message.length > 0 ? Editor.knotFiles.message : sheet.hint
        color: sheet.chosen >= 0 ? (sheet.chosenUsable ? Theme.color.ink : Theme.color.fault)
            : Editor.knotFiles.failed ? Theme.color.fault : Editor.knotFiles.message.length > 0 ? Theme.color.ink : Theme.color.secondaryInk
        font.pixelSize: Theme.size.body
    }
    Button {
        id: lookButton
        objectName: "lookAgain"
        anchors { right: goOnButton.left; rightMargin: Theme.size.spacing; bottom: parent.bottom }
        glyph: Theme.icon.refresh
        onClicked: sheet.look()
    }
    Button {
        id: goOnButton
        objectName: "knotFilesGo"
        anchors { right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        enabled: sheet.chosen >= 0 && sheet.chosenUsable && !Editor.knotFiles.busy
        text: sheet.exports ? qsTr("Write file") : qsTr("Import")
        onClicked: sheet.goOn()
    }
}
