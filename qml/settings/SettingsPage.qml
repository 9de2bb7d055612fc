// SPDX-License-Identifier: Apache-2.0
// Settings: sections on the left, the selected one on the right.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    function open(source: string): void {
        page.section = page.sections.findIndex(row => row.source === source)
    }

    property int section
    readonly property string machineName: Settings.setting("machine.name").shown
    readonly property var sections: [
        { name: "section0", text: qsTr("Display"), note: qsTr("language, units, theme"), source: "DisplaySection.qml" },
        { name: "section1", text: qsTr("Connection"), note: qsTr("simulated or serial port"), source: "ConnectionSection.qml" },
        { name: "section2", text: qsTr("Machine"), note: page.machineName.length > 0 ? page.machineName : qsTr("drive, gear, motor limits"), source: "MachineSection.qml" },
        { name: "sectionUsers", text: qsTr("Users"), note: qsTr("PINs, levels, audit"), source: "UsersSection.qml" },
        { name: "section3", text: qsTr("About"), note: qsTr("versions, disk, safety"), source: "AboutSection.qml" },
        { source: "SystemSection.qml", within: 0 },
        { source: "StopsSection.qml", within: 2 },
        { source: "MasterSetupSection.qml", within: 2 },
        { source: "VersionsSection.qml", within: 4 },
        { source: "PermitSection.qml", within: 2 },
        { source: "TowerSection.qml", within: 2 },
        { source: "AxesSection.qml", within: 2 }
    ]
    readonly property var menu: sections.filter(row => row.within === undefined)
    readonly property int shown: sections[section].within ?? section // in the menu

    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { top: parent.top; bottom: parent.bottom; bottomMargin: page.bottomInset }
        Column {
            id: column
            anchors { fill: parent; margins: Theme.size.spacing }
            spacing: Theme.size.spacing
            Repeater {
                model: page.menu
                ChoiceRow {
                    required property int index
                    required property var modelData
                    objectName: modelData.name
                    width: column.width
                    height: (column.height - (page.menu.length - 1) * column.spacing) / page.menu.length
                    text: modelData.text
                    note: modelData.note
                    noteLabel.maximumLineCount: 2
                    holds: page.shown === index
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
            onLoaded: (item as SettingsSection).settings = page
        }
    }
}
