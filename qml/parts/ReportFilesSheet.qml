// SPDX-License-Identifier: Apache-2.0
// The place for a report: a USB stick or the panel's own folder.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property int chosen: -1
    property string chosenDetail
    property bool chosenUsable

    property ReportFiles files: Service.files
    readonly property string hint: sheet.files.busy ? qsTr("Searching …") : qsTr("Choose the location of the new files.")

    // Searches again, to find a stick when it is plugged in.
    Timer {
        interval: Theme.lookAgainTime
        repeat: true
        running: sheet.chosen < 0
        onTriggered: sheet.files.refresh()
    }
    ListView {
        id: list
        objectName: "reportPlaces"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: writeButton.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.files.places
        delegate: ChoiceRow {
            required property int index
            required property string title
            required property string detail
            required property bool usable
            required note
            objectName: "place" + index
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
        objectName: "placeDetail"
        anchors { left: parent.left; right: lookButton.left; rightMargin: Theme.size.padding; top: writeButton.top; bottom: parent.bottom }
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.size.caption - 3
        text: sheet.chosen >= 0 ? sheet.chosenDetail : sheet.files.message.length > 0 ? sheet.files.message : sheet.hint
        color: sheet.chosen >= 0 ? (sheet.chosenUsable ? Theme.color.ink : Theme.color.fault)
            : sheet.files.failed ? Theme.color.fault : sheet.files.message.length > 0 ? Theme.color.ink : Theme.color.secondaryInk
    }
    Button {
        id: lookButton
        anchors { right: writeButton.left; rightMargin: Theme.size.spacing; bottom: parent.bottom }
        glyph: Theme.icon.refresh
        onClicked: {
            sheet.chosen = -1
            sheet.files.look()
        }
    }
    Button {
        id: writeButton
        objectName: "reportWrite"
        anchors { right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        enabled: sheet.chosen >= 0 && sheet.chosenUsable && !sheet.files.busy
        text: qsTr("Write file")
        onClicked: {
            sheet.files.write(sheet.chosen)
            sheet.chosen = -1
        }
    }
}
