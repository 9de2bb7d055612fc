// SPDX-License-Identifier: Apache-2.0
// Backups on a USB stick or in the panel's own folder: the contents of the selected one are below, then it is checked.
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
    readonly property bool hasMessage: Backup.message.length > 0

    title: qsTr("Restore a backup")
    Component.onCompleted: Backup.look()

    // Searches again, to find a stick when it is plugged in.
    Timer {
        interval: Theme.lookAgainTime
        repeat: true
        running: sheet.chosen < 0
        onTriggered: Backup.refresh()
    }
    ListView {
        id: list
        objectName: "backupFiles"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: checkButton.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Backup.found
        delegate: ChoiceRow {
            required property int index
            required property string title
            required property string detail
            required property bool usable
            required note
            objectName: "backupFile" + index
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
        objectName: "backupDetail"
        anchors { left: parent.left; right: checkButton.left; rightMargin: Theme.size.padding; top: checkButton.top; bottom: parent.bottom }
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.size.caption - 3
        text: Backup.busy ? (sheet.chosen >= 0 ? qsTr("Checking …") : qsTr("Searching …"))
            : sheet.hasMessage ? Backup.message : sheet.chosen >= 0 ? sheet.chosenDetail
            : list.count > 0 ? qsTr("Choose a file to view its content.")
            : qsTr("There is no backup on a USB stick or on this panel. Plug a stick in; the panel finds it automatically.")
        color: sheet.hasMessage || sheet.chosen >= 0 && !sheet.chosenUsable ? Theme.color.fault
            : sheet.chosen >= 0 ? Theme.color.ink : Theme.color.secondaryInk
    }
    Button {
        id: checkButton
        objectName: "backupCheck"
        anchors { right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        enabled: sheet.chosen >= 0 && sheet.chosenUsable && !Backup.busy
        text: qsTr("Check and restore")
        onClicked: Backup.check(sheet.chosen)
    }
}
