// SPDX-License-Identifier: Apache-2.0
// The starts of the shifts, moved by quarters of an hour, and the working days.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property int chosen
    property int minutes                   // of the chosen start
    property int earliest
    property int latest
    readonly property StopSetup setup: Stops.setup
    readonly property int count: setup.starts.count
    readonly property var workingDays: setup.workingDays

    title: qsTr("Shifts")
    note: qsTr("A shift lasts until the next one starts. It belongs to the day on which it starts.")

    component Step: Button {
        required property int by
        level: Access.Service
        width: (keys.width - keys.spacing) / 2
        enabled: sheet.minutes + by >= sheet.earliest && sheet.minutes + by <= sheet.latest
        onClicked: sheet.setup.moveStart(sheet.chosen, by)
    }

    ListView {
        id: list
        anchors { left: parent.left; top: parent.top; bottom: dayLabel.top; bottomMargin: Theme.size.spacing }
        width: Math.round(parent.width * 0.42)
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.setup.starts
        delegate: ChoiceRow {
            id: start
            required property int index
            required property int minutes
            required property int earliest
            required property int latest
            required text
            objectName: "shiftStart" + index
            holds: sheet.chosen === index
            onClicked: sheet.chosen = index
            Binding { target: sheet; property: "minutes"; value: start.minutes; when: start.holds; restoreMode: Binding.RestoreNone }
            Binding { target: sheet; property: "earliest"; value: start.earliest; when: start.holds; restoreMode: Binding.RestoreNone }
            Binding { target: sheet; property: "latest"; value: start.latest; when: start.holds; restoreMode: Binding.RestoreNone }
        }
    }
    ScrollMark { view: list }
    Grid {
        id: keys
        anchors { left: list.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top }
        columns: 2
        spacing: Theme.size.spacing
        Step {
            objectName: "startEarlierHour"
            by: -60
            text: qsTr("− 1 h")
        }
        Step {
            objectName: "startLaterHour"
            by: 60
            text: qsTr("+ 1 h")
        }
        Step {
            objectName: "startEarlier"
            by: -15
            text: qsTr("− 15 min")
        }
        Step {
            objectName: "startLater"
            by: 15
            text: qsTr("+ 15 min")
        }
        Button {
            objectName: "startAdd"
            level: Access.Service
            width: (keys.width - keys.spacing) / 2
            enabled: sheet.setup.canAddStart
            text: qsTr("Add a shift")
            onClicked: sheet.setup.addStart()
        }
        Button {
            objectName: "startRemove"
            level: Access.Service
            width: (keys.width - keys.spacing) / 2
            enabled: sheet.count > 1
            text: qsTr("Remove")
            onClicked: {
                const row = sheet.chosen
                sheet.chosen = Math.max(0, Math.min(row, sheet.count - 2))
                sheet.setup.removeStart(row)
            }
        }
    }
    Label {
        id: dayLabel
        anchors { left: parent.left; right: parent.right; bottom: days.top; bottomMargin: Theme.size.accent }
        text: qsTr("Working days")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Row {
        id: days
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.accent
        Repeater {
            model: sheet.setup.dayNames.length
            Button {
                required property int index
                readonly property bool works: sheet.workingDays.includes(index + 1)
                objectName: "workingDay" + (index + 1)
                level: Access.Service
                width: (days.width - 6 * days.spacing) / 7
                glyph: works ? Theme.icon.check : ""
                text: sheet.setup.dayNames[index]
                onClicked: sheet.setup.toggleDay(index + 1)
            }
        }
    }
}
