// SPDX-License-Identifier: Apache-2.0
// Service: the technician's pages, one section at a time in the full width. Three groups: the line to the controller, the
// machine, and the panel's data.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    property int group
    property var chosen: [0, 0, 0]         // the key of each group's section
    readonly property var line: [
        { key: 0, name: "maintenance0", text: qsTr("Diagnostics"), source: "DoctorSection.qml" },
        { key: 1, name: "maintenance1", text: qsTr("Statistics"), source: "FiguresSection.qml" },
        { key: 2, name: "maintenance2", text: qsTr("Registers"), source: "RegistersSection.qml" },
        { key: 3, name: "maintenance3", text: qsTr("Frames"), source: "FramesSection.qml" }
    ]
    readonly property var simulatedLine: page.line.concat([{ key: 4, name: "maintenance4", text: qsTr("Faults"), source: "SimulatedFaultsSection.qml" }])
    readonly property var machine: [
        { key: 0, name: "maintenanceJog", text: qsTr("Jog"), source: "JogSection.qml" },
        { key: 1, name: "maintenanceHoming", text: qsTr("Reference"), source: "HomingSection.qml" },
        { key: 2, name: "maintenanceIo", text: qsTr("I/O"), source: "IoSection.qml" },
        { key: 3, name: "maintenancePacking", text: qsTr("Packing"), source: "../Packing/PackingSection.qml" },
        { key: 4, name: "maintenanceMaster", text: qsTr("Master"), source: "MasterSection.qml" },
        { key: 5, name: "maintenanceDryRun", text: qsTr("Dry run"), source: "DryRunSection.qml" }
    ]
    readonly property var memory: [{ key: 0, name: "maintenanceBackup", text: qsTr("Backup"), source: "../Reports/BackupSection.qml" },
        { key: 1, name: "maintenanceScanner", text: qsTr("Scanner"), source: "../Scan/ScannerSection.qml" }]
    readonly property var groups: [
        { key: 0, name: "maintenanceLine", text: qsTr("Link"), glyph: Theme.icon.serialPort },
        { key: 1, name: "maintenanceMachine", text: qsTr("Machine"), glyph: Theme.icon.machine },
        { key: 2, name: "maintenancePanel", text: qsTr("Panel"), glyph: Theme.icon.save }
    ]
    // With keys for gloves they do not fit beside the longest group: one key then opens the choice of groups.
    readonly property bool oneGroupKey: width < (groups.length + machine.length) * Theme.size.touch + Theme.size.spacing
    readonly property var all: [Controller.simulated ? page.simulatedLine : page.line, page.machine, page.memory]
    readonly property var shown: page.all[page.group][Math.min(page.chosen[page.group], page.all[page.group].length - 1)]

    Segmented {
        id: groupKeys
        anchors { left: parent.left; top: parent.top }
        width: choices.length * Theme.size.touch
        color: Theme.color.surface
        stacked: true
        choices: page.oneGroupKey ? [Object.assign({}, page.groups[page.group], { name: "maintenanceGroup" })] : page.groups
        current: page.group
        onChosen: key => {
            if (page.oneGroupKey)
                Frame.open("Controls/ListPicker", {
                    title: qsTr("Maintenance"), current: page.group, onChosen: key => page.group = key,
                    choices: [{ key: 0, text: qsTr("Connection to the controller") }, { key: 1, text: qsTr("Machine") }, { key: 2, text: qsTr("Panel data") }]
                })
            else
                page.group = key
        }
    }
    Segmented {
        id: tabs
        anchors { left: groupKeys.right; leftMargin: Theme.size.spacing; right: parent.right; top: parent.top }
        color: Theme.color.surface
        choices: page.all[page.group]
        current: page.shown.key
        onChosen: key => page.chosen = page.chosen.map((before, group) => group === page.group ? key : before)
    }
    Card {
        anchors { left: parent.left; right: parent.right; top: tabs.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: page.bottomInset }
        Loader {
            anchors { fill: parent; margins: Theme.size.padding }
            source: page.shown.source
        }
    }
}
