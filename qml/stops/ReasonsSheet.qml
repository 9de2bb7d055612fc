// SPDX-License-Identifier: Apache-2.0
// The list of reasons: eight groups with eight reasons each are added, renamed, marked as planned, removed.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property int chosen
    property string chosenText
    property bool chosenPlanned
    readonly property ReasonEditor editor: Stops.setup.reasons
    readonly property int count: editor.rows.count
    readonly property bool inGroup: editor.groupText.length > 0
    signal nameRequested(int row, string text)
    signal standardRequested()

    title: sheet.inGroup ? qsTr("Reasons: %1").arg(sheet.editor.groupText) : qsTr("Reasons of a stop")
    note: qsTr("Planned stops are not counted as losses. Earlier stops keep their reason.")
    onInGroupChanged: sheet.chosen = 0

    ListView {
        id: list
        objectName: "reasonRows"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: keys.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.editor.rows
        delegate: ChoiceRow {
            id: row
            required property int index
            required property bool isPlanned
            required property bool opens
            required text
            objectName: "reasonRow" + index
            note: isPlanned ? qsTr("planned") : opens ? qsTr("more …") : ""
            holds: sheet.chosen === index
            onClicked: sheet.chosen = index
            Binding { target: sheet; property: "chosenText"; value: row.text; when: row.holds; restoreMode: Binding.RestoreNone }
            Binding { target: sheet; property: "chosenPlanned"; value: row.isPlanned; when: row.holds; restoreMode: Binding.RestoreNone }
        }
    }
    ScrollMark { view: list }
    Label {
        anchors { left: list.left; top: list.top }
        visible: sheet.count === 0
        text: qsTr("This group has no reasons yet.")
        color: Theme.color.secondaryInk
    }
    Row {
        id: keys
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.spacing
        readonly property real each: (width - 5 * spacing) / 6
        Button {
            objectName: "reasonOpen"
            width: keys.each
            text: sheet.inGroup ? qsTr("Back") : qsTr("Open")
            onClicked: sheet.inGroup ? sheet.editor.closeGroup() : sheet.editor.openGroup(sheet.chosen)
        }
        Button {
            objectName: "reasonAdd"
            level: Access.Service
            width: keys.each
            enabled: sheet.editor.canAdd
            text: qsTr("Add")
            onClicked: sheet.nameRequested(-1, "")
        }
        Button {
            objectName: "reasonRename"
            level: Access.Service
            width: keys.each
            enabled: sheet.chosen < sheet.count
            text: qsTr("Rename")
            onClicked: sheet.nameRequested(sheet.chosen, sheet.chosenText)
        }
        Button {
            objectName: "reasonPlanned"
            level: Access.Service
            width: keys.each
            enabled: sheet.chosen < sheet.count
            glyph: sheet.chosenPlanned && sheet.chosen < sheet.count ? Theme.icon.check : ""
            text: qsTr("Planned")
            onClicked: sheet.editor.togglePlanned(sheet.chosen)
        }
        Button {
            objectName: "reasonRemove"
            level: Access.Service
            width: keys.each
            enabled: sheet.chosen < sheet.count && (sheet.inGroup || sheet.count > 1)
            text: qsTr("Remove")
            onClicked: {
                const row = sheet.chosen
                sheet.chosen = Math.max(0, Math.min(row, sheet.count - 2))
                sheet.editor.remove(row)
            }
        }
        Button {
            objectName: "reasonStandard"
            level: Access.Service
            width: keys.each
            enabled: sheet.editor.isOwn
            text: qsTr("Standard list")
            onClicked: sheet.standardRequested()
        }
    }
}
