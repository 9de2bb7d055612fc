// SPDX-License-Identifier: Apache-2.0
// Stops: when the reason is asked for, ideal rate, shifts, and the list of reasons. For the level Service.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property real half: (width - Theme.size.spacing) / 2
    readonly property StopSetup setup: Stops.setup

    function openReasons(): void {
        Frame.open("Stops/ReasonsSheet", { onNameRequested: (row, text) => section.enterName(row, text), onStandardRequested: () => section.askForStandard() })
    }
    // Names that reason, -1: a new one.
    function enterName(row: int, text: string): void {
        if (!Access.ask(Access.Service))
            return
        const reasons = section.setup.reasons
        Frame.open("Parts/TextSheet", {
            title: qsTr("Name of the reason"), text: text, level: Access.Service, check: name => reasons.problemOf(row, name),
            onAccepted: name => {
                if (row < 0)
                    reasons.add(name)
                else
                    reasons.rename(row, name)
                section.openReasons()
            }
        })
    }
    function askForStandard(): void {
        if (!Access.ask(Access.Service))
            return
        Frame.open("Parts/ConfirmSheet", {
            title: qsTr("Standard list"), question: qsTr("Replace the own list by the standard list? Stops keep their reasons."),
            ways: [{ key: "restore", text: qsTr("Replace"), primary: true, level: Access.Service }],
            onChosen: () => {
                section.setup.reasons.restoreStandard()
                section.openReasons()
            }
        })
    }

    title: qsTr("Stops and shifts")

    Grid {
        y: section.bodyTop
        columns: 2
        spacing: Theme.size.spacing
        SettingTile {
            objectName: "stopsAskAfter"
            width: section.half
            name: "stops.ask_after_seconds"
        }
        SettingTile {
            objectName: "stopsIdealRate"
            width: section.half
            name: "stops.ideal_rate"
            heading: qsTr("Ideal rate (0: by recipe)")
        }
        SettingRow {
            objectName: "stopsShifts"
            level: Access.Service
            width: section.half
            label: qsTr("Shifts start at")
            value: section.setup.shiftsText
            onClicked: if (Access.ask(Access.Service)) Frame.open("Stops/ShiftsSheet", {})
        }
        SettingRow {
            objectName: "stopsDays"
            level: Access.Service
            width: section.half
            label: qsTr("Working days")
            value: section.setup.daysText
            onClicked: if (Access.ask(Access.Service)) Frame.open("Stops/ShiftsSheet", {})
        }
        SettingRow {
            objectName: "stopsReasons"
            level: Access.Service
            width: section.half
            label: qsTr("Reasons of a stop")
            value: section.setup.reasonsText
            onClicked: {
                section.setup.reasons.closeGroup()
                if (Access.ask(Access.Service))
                    section.openReasons()
            }
        }
    }
}
