// SPDX-License-Identifier: Apache-2.0
// Alarms: the active, earlier and shelved ones. A tap displays cause and action.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    property int section
    readonly property real keysWidth: Math.max(acknowledgeAll.implicitWidth, 2 * Theme.size.touch + Theme.size.spacing)

    Segmented {
        id: tabs
        // The space of the hidden key stays free, so that a new alarm moves nothing under a finger.
        anchors { left: parent.left; right: parent.right; top: parent.top; rightMargin: page.keysWidth + Theme.size.spacing }
        color: Theme.color.surface
        choices: [{ key: 0, name: "alarmsLive", text: Alarms.unacknowledged > 0 ? qsTr("Active, %1 new").arg(Alarms.unacknowledged) : qsTr("Active") },
            { key: 1, name: "alarmsHistory", text: qsTr("History") },
            { key: 2, name: "alarmsShelved", text: Alarms.shelved.count > 0 ? qsTr("Shelved: %1").arg(Alarms.shelved.count) : qsTr("Shelved") }]
        current: page.section
        onChosen: key => page.section = key
    }
    Button {
        id: acknowledgeAll
        objectName: "alarmsAcknowledgeAll"
        level: Access.Operator
        anchors { right: parent.right; top: parent.top }
        width: page.keysWidth
        visible: page.section === 0 && Alarms.unacknowledged > 0
        kind: Button.Primary
        text: qsTr("Acknowledge all")
        onClicked: Alarms.acknowledgeAll()
    }
    Row {
        id: historyKeys
        anchors { right: parent.right; top: parent.top }
        width: page.keysWidth
        visible: page.section === 1
        spacing: Theme.size.spacing
        Button {
            objectName: "alarmsFilter"
            width: (parent.width - parent.spacing) / 2
            text: qsTr("Filter")
            onClicked: filterDialogs.open()
        }
        Button {
            objectName: "alarmsCsv"
            level: Access.Operator
            width: (parent.width - parent.spacing) / 2
            text: qsTr("CSV")
            enabled: Alarms.history.rows.count > 0 && !Alarms.history.csv.busy
            onClicked: if (Access.ask(Access.Operator)) Alarms.history.csv.make(Maintenance.files)
        }
    }
    LogFilterStrip {
        id: strip
        anchors { left: parent.left; right: parent.right; top: tabs.bottom; topMargin: Theme.size.spacing }
        filter: Alarms.history.filter
        shown: page.section === 1
    }
    Card {
        anchors { left: parent.left; right: parent.right; top: strip.visible ? strip.bottom : tabs.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: page.bottomInset }
        AlarmList {
            anchors { fill: parent; margins: Theme.size.spacing }
            visible: page.section === 0
            rows: Alarms.live
            listName: "liveAlarm"
            emptyText: qsTr("No alarm is active or waiting for acknowledgment.")
            emptyGlyph: Theme.icon.good
            onOpened: row => {
                Alarms.showLive(row)
                Frame.open("Alarms/AlarmSheet", {})
            }
        }
        AlarmList {
            anchors { fill: parent; margins: Theme.size.spacing }
            visible: page.section === 1
            rows: Alarms.history.rows
            listName: "pastAlarm"
            emptyText: Alarms.history.loading ? qsTr("Reading the log …")
                : Alarms.history.filter.active ? qsTr("No alarm matches the filter.") : qsTr("No alarm since the start of this log.")
            onOpened: row => {
                Alarms.showHistory(row)
                Frame.open("Alarms/AlarmSheet", {})
            }
        }
        ShelvedList {
            anchors { fill: parent; margins: Theme.size.spacing }
            visible: page.section === 2
        }
    }
    Binding {
        target: Alarms.history
        property: "watched"
        value: page.visible && page.section === 1
    }
    Connections {
        target: Alarms.history.csv
        function onReady() { Frame.open("Parts/ReportFilesSheet", { title: qsTr("Alarms as CSV"), note: Alarms.history.filter.summary }) }
    }
    LogFilterDialogs {
        id: filterDialogs
        filter: Alarms.history.filter
        idLabel: qsTr("Alarm number")
    }
}
