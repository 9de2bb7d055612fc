// SPDX-License-Identifier: Apache-2.0
// Language, theme and keys for gloves; all change at once, on every page. A key leads to the settings of the computer.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property var themeChoices: ({
        light: { key: "light", text: qsTr("Light"), glyph: Theme.icon.light },
        dark: { key: "dark", text: qsTr("Dark"), glyph: Theme.icon.dark },
        contrast: { key: "contrast", text: qsTr("High contrast"), glyph: Theme.icon.contrast }
    })

    readonly property var labels: Settings.labels
    readonly property var languages: Settings.languages
    readonly property var languageNames: Settings.languageNames
    readonly property var themes: Settings.themes

    // Taller keys if there is space.
    readonly property real keyHeight: Math.max(Theme.size.touch, Math.min(1.5 * Theme.size.touch, (height - bodyTop) / 4))

    title: qsTr("Display")

    Column {
        y: section.bodyTop
        width: parent.width
        spacing: Theme.size.spacing
        Row {
            id: upper
            readonly property real half: (width - spacing) / 2
            width: parent.width
            spacing: Theme.size.gap
            SettingRow {
                objectName: "languageChoice"
                width: upper.half
                height: gloves.height
                label: section.labels.language
                value: section.languageNames[section.languages.indexOf(Settings.language)] ?? ""
                onClicked: Frame.open("Controls/ListPicker", {
                    title: section.labels.language, choices: section.languages.map((key, i) => ({ key: key, text: section.languageNames[i] })),
                    current: Settings.language, onChosen: key => Settings.language = key
                })
            }
            Column {
                id: gloves
                width: upper.half
                spacing: Theme.size.spacing
                Label {
                    width: parent.width
                    fontSizeMode: Text.HorizontalFit
                    minimumPixelSize: Theme.size.caption - 2
                    text: section.labels.gloves
                    color: Theme.color.secondaryInk
                }
                Segmented {
                    objectName: "glovesChoice"
                    width: parent.width
                    height: section.keyHeight
                    choices: [{ key: false, text: qsTr("Off"), name: "glovesOff" }, { key: true, text: qsTr("On"), name: "glovesOn" }]
                    current: Settings.gloves
                    onChosen: key => Settings.gloves = key
                }
            }
        }
        Item { width: 1; height: Theme.size.spacing }
        Label {
            text: section.labels.theme
            color: Theme.color.secondaryInk
        }
        Segmented {
            objectName: "themeChoice"
            width: parent.width
            height: section.keyHeight
            choices: section.themes.map(key => section.themeChoices[key])
            current: Settings.theme
            onChosen: key => Settings.theme = key
        }
        Item { width: 1; height: Theme.size.spacing }
        Row {
            width: parent.width
            spacing: Theme.size.spacing
            Button {
                id: system
                objectName: "sectionSystem"
                text: qsTr("Screen, clock, network")
                onClicked: section.settings.open("SystemSection.qml")
            }
            SettingRow {
                objectName: "holdToStart"
                width: parent.width - system.width - parent.spacing
                height: system.height
                label: qsTr("Start key")
                value: Settings.startIsHeld ? qsTr("hold") : qsTr("tap")
                onClicked: {
                    if (!Access.ask(Access.Technician))
                        return
                    Frame.open("Controls/ListPicker", {
                        title: qsTr("Start key"), current: Settings.holdToStart, onChosen: key => Settings.holdToStart = key,
                        choices: [{ key: "auto", text: qsTr("Automatic"), note: qsTr("hold with a real controller") },
                            { key: "on", text: qsTr("Hold for 0.5 s"), note: qsTr("an accidental touch does not start the machine") },
                            { key: "off", text: qsTr("One touch"), note: "" }]
                    })
                }
            }
        }
        Label {
            visible: parent.y + y + implicitHeight <= section.height // only if there is space
            width: parent.width
            wrapMode: Text.WordWrap
            text: qsTr("Use light in a bright hall, dark in the night shift, high contrast for a dirty screen. Glove mode enlarges all keys by a quarter; numbers and units follow the language.")
            color: Theme.color.secondaryInk
        }
    }
}
