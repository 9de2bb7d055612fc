// SPDX-License-Identifier: Apache-2.0
// Service: what a technician needs of the line and the controller, one section at a time in the full width.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Widgets
import CamPanel.Machine

Page {
    id: page

    property int section
    readonly property var always: [
        { key: 0, name: "service0", text: qsTr("Link doctor"), source: "DoctorSection.qml" },
        { key: 1, name: "service1", text: qsTr("Figures"), source: "FiguresSection.qml" },
        { key: 2, name: "service2", text: qsTr("Registers"), source: "RegistersSection.qml" },
        { key: 3, name: "service3", text: qsTr("Frames"), source: "FramesSection.qml" },
        { key: 4, name: "servicePacking", text: qsTr("Packing"), source: "PackingSection.qml" }
    ]
    readonly property var simulatedOnly: [{ key: 5, name: "service4", text: qsTr("Faults"), source: "LineFaultsSection.qml" }]
    readonly property var sections: Machine.simulated ? page.always.concat(page.simulatedOnly) : page.always
    readonly property int shown: Math.min(page.section, page.sections.length - 1)

    Segmented {
        id: tabs
        anchors { left: parent.left; right: parent.right; top: parent.top }
        color: Theme.color.surface
        choices: page.sections
        current: page.shown
        onChosen: key => page.section = key
    }
    Card {
        anchors { left: parent.left; right: parent.right; top: tabs.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: page.bottomInset }
        Loader {
            anchors { fill: parent; margins: Theme.size.padding }
            source: page.always.concat(page.simulatedOnly)[page.shown].source
            onLoaded: (item as ServiceSection).page = page
        }
    }
}
