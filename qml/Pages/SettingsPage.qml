// SPDX-License-Identifier: Apache-2.0
// Settings: sections at the left, the chosen one at the right.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Widgets

Page {
    id: page

    property int section
    readonly property var sections: [
        { text: qsTr("Display"), note: qsTr("language, light or dark"), source: "DisplaySection.qml" },
        { text: qsTr("Connection"), note: qsTr("simulated or serial port"), source: "ConnectionSection.qml" },
        { text: qsTr("Machine"), note: qsTr("drive, gear, motor limits"), source: "MachineSection.qml" },
        { text: qsTr("About"), note: qsTr("version, safety"), source: "AboutSection.qml" }
    ]

    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { top: parent.top; bottom: parent.bottom; bottomMargin: page.bottomInset }
        Column {
            id: menu
            anchors { fill: parent; margins: Theme.size.spacing }
            spacing: Theme.size.spacing
            Repeater {
                model: page.sections
                ChoiceRow {
                    required property int index
                    required property var modelData
                    objectName: "section" + index
                    width: menu.width
                    height: (menu.height - (page.sections.length - 1) * menu.spacing) / page.sections.length
                    text: modelData.text
                    note: modelData.note
                    holds: page.section === index
                    onClicked: page.section = index
                }
            }
        }
    }
    Card {
        anchors { left: side.right; leftMargin: Theme.size.gap; right: parent.right; top: parent.top; bottom: side.bottom }
        Loader {
            anchors { fill: parent; margins: Theme.size.padding }
            source: page.sections[page.section].source
            onLoaded: (item as SettingsSection).page = page
        }
    }
}
