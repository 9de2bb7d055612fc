// SPDX-License-Identifier: Apache-2.0
// Stops: when the reason is asked for, ideal rate, shifts, and the list of reasons. For the level Service.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Stops
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property real half: (width - Theme.size.spacing) / 2
    readonly property StopSetup setup: Stops.setup
    property int row                       // of the reason that is named; -1: a new one
    property string name

    function open(sheet: Component): void {
        if (Access.ask(Access.Service))
            section.page.sheetRequested(sheet)
    }

    title: qsTr("Stops and shifts")

    Grid {
        y: section.bodyTop
        columns: 2
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "stopsAskAfter"
            width: section.half
            label: section.setup.askAfter.label
            value: qsTr("%1 s").arg(section.setup.askAfter.text)
            onClicked: section.open(askKeypad)
        }
        SettingRow {
            objectName: "stopsIdealRate"
            width: section.half
            label: qsTr("Ideal rate")
            value: section.setup.idealRateText
            onClicked: section.open(idealKeypad)
        }
        SettingRow {
            objectName: "stopsShifts"
            width: section.half
            label: qsTr("Shifts start at")
            value: section.setup.shiftsText
            onClicked: section.open(shiftsSheet)
        }
        SettingRow {
            objectName: "stopsDays"
            width: section.half
            label: qsTr("Working days")
            value: section.setup.daysText
            onClicked: section.open(shiftsSheet)
        }
        SettingRow {
            objectName: "stopsReasons"
            width: section.half
            label: qsTr("Reasons of a stop")
            value: section.setup.reasonsText
            onClicked: {
                section.setup.reasons.closeGroup()
                section.open(reasonsSheet)
            }
        }
    }
    Component {
        id: askKeypad
        ValueKeypad { value: section.setup.askAfter }
    }
    Component {
        id: idealKeypad
        ValueKeypad { value: section.setup.idealRate }
    }
    Component {
        id: shiftsSheet
        ShiftsSheet {}
    }
    Component {
        id: reasonsSheet
        ReasonsSheet {
            onNameRequested: (row, text) => {
                section.row = row
                section.name = text
                section.page.sheetRequested(nameSheet)
            }
            onStandardRequested: section.page.sheetRequested(standardSheet)
        }
    }
    Component {
        id: nameSheet
        TextSheet {
            title: qsTr("Name of the reason")
            text: section.name
            problem: section.setup.reasons.problemOf(section.row, section.name)
            onEdited: text => section.name = text
            onAccepted: {
                if (section.row < 0)
                    section.setup.reasons.add(section.name)
                else
                    section.setup.reasons.rename(section.row, section.name)
                section.page.sheetRequested(reasonsSheet)
            }
        }
    }
    Component {
        id: standardSheet
        ConfirmSheet {
            title: qsTr("Standard list")
            question: qsTr("Replace the own list by the standard list? Stops keep their reasons.")
            ways: [{ key: "restore", text: qsTr("Replace"), primary: true }]
            onChosen: {
                section.setup.reasons.restoreStandard()
                section.page.sheetRequested(reasonsSheet)
            }
        }
    }
}
