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
            SettingTile {
                objectName: "languageChoice"
                width: upper.half
                height: gloves.height
                name: "display.language"
            }
            Column {
                id: gloves
                width: upper.half
                spacing: Theme.size.spacing
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
        }
        Item { width: 1; height: Theme.size.spacing }
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
            SettingTile {
                objectName: "holdToStart"
                width: parent.width - system.width - parent.spacing
                height: system.height
                name: "access.hold_to_start"
                value: Settings.startIsHeld ? qsTr("hold") : qsTr("tap")
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
