// SPDX-License-Identifier: Apache-2.0
// Language, units, theme and keys for gloves; all change at once, on every page. A key leads to the settings of the computer.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    // Taller keys if there is space.
    readonly property real keyHeight: Math.max(Theme.size.touch, Math.min(1.5 * Theme.size.touch, (height - bodyTop) / 6))
    readonly property real half: (width - Theme.size.spacing) / 2

    title: qsTr("Display")

    Column {
        y: section.bodyTop
        width: parent.width
        spacing: Theme.size.spacing
        Row {
            width: parent.width
            spacing: Theme.size.spacing
            SettingTile {
                objectName: "languageChoice"
                width: section.half
                name: "display.language"
            }
            SettingTile {
                objectName: "unitsChoice"
                width: section.half
                name: "display.units"
            }
        }
        Row {
            width: parent.width
            spacing: Theme.size.spacing
            Column {
                id: gloves
                width: section.half
                spacing: Theme.size.outline
                Label {
                    width: parent.width
                    fontSizeMode: Text.HorizontalFit
                    minimumPixelSize: Theme.size.caption - 2
                    text: glovesKeys.field.label
                    color: Theme.color.secondaryInk
                }
                SettingKeys {
                    id: glovesKeys
                    objectName: "glovesChoice"
                    width: parent.width
                    height: section.keyHeight
                    name: "display.gloves"
                    keyName: "gloves"
                }
            }
            SettingTile {
                objectName: "holdToStart"
                width: section.half
                height: gloves.height
                name: "access.hold_to_start"
                value: Settings.startIsHeld ? qsTr("hold") : qsTr("tap")
            }
        }
        Column {
            width: parent.width
            spacing: Theme.size.outline
            Label {
                text: themeKeys.field.label
                color: Theme.color.secondaryInk
            }
            SettingKeys {
                id: themeKeys
                objectName: "themeChoice"
                width: parent.width
                height: section.keyHeight
                name: "display.theme"
                glyphs: ({ light: Theme.icon.light, dark: Theme.icon.dark, contrast: Theme.icon.contrast })
            }
        }
        Button {
            objectName: "sectionSystem"
            width: parent.width
            text: qsTr("Screen, clock, network")
            onClicked: section.settings.open("SystemSection.qml")
        }
        Label {
            visible: parent.y + y + implicitHeight <= section.height // only if there is space
            width: parent.width
            wrapMode: Text.WordWrap
            text: qsTr("Use light in a bright hall, dark in the night shift, high contrast for a dirty screen. Glove mode enlarges all keys by a quarter; numbers follow the language. Recipes and files stay metric.")
            color: Theme.color.secondaryInk
        }
    }
}
