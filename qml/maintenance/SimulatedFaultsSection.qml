// SPDX-License-Identifier: Apache-2.0
// Faults of the simulated machine and of the line to it: predefined faults, each off, sometimes or often, or off and on.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property SimulatedFaults faults: Maintenance.simulatedFaults

    ListView {
        id: list
        objectName: "faultList"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: section.faults.rows
        delegate: ListRow {
            id: row
            required property int index
            required property string name
            required note
            required property int rate
            required property bool isSwitch
            required property bool isLine
            tappable: false
            text: name
            titleLabel.color: rate === SimulatedFaults.Off ? Theme.color.ink : Theme.color.warning
            noteLabel { wrapMode: Text.WordWrap; fontSizeMode: Text.FixedSize; maximumLineCount: 2 }
            rightPadding: choice.width
            Segmented {
                id: choice
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                width: Math.round(parent.width * 0.56)
                level: Access.Technician
                readonly property var off: ({ key: SimulatedFaults.Off, text: qsTr("Off"), name: "fault" + row.index + "off" })
                choices: row.isLine ? [choice.off, { key: SimulatedFaults.Sometimes, text: Theme.measure(50, 0, "%"), name: "fault" + row.index + "half" },
                        { key: SimulatedFaults.Often, text: Theme.measure(100, 0, "%"), name: "fault" + row.index + "full" },
                        { key: SimulatedFaults.Beyond, text: Theme.measure(120, 0, "%"), name: "fault" + row.index + "beyond" }]
                    : row.isSwitch ? [choice.off, { key: SimulatedFaults.Often, text: qsTr("On"), name: "fault" + row.index + "on" }]
                    : [choice.off, { key: SimulatedFaults.Sometimes, text: qsTr("Sometimes"), name: "fault" + row.index + "sometimes" },
                        { key: SimulatedFaults.Often, text: qsTr("Often"), name: "fault" + row.index + "often" }]
                current: row.rate
                onChosen: key => section.faults.setLevel(row.index, key)
            }
        }
    }
    ScrollMark { view: list }
    Item {
        id: foot
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        Label {
            objectName: "faultsText"
            anchors { left: parent.left; right: off.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            height: parent.height
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: section.faults.errorText.length > 0 ? section.faults.errorText : section.faults.text
            color: section.faults.errorText.length > 0 ? Theme.color.fault : section.faults.activeCount > 0 ? Theme.color.warning : Theme.color.secondaryInk
        }
        Button {
            id: off
            objectName: "faultsOff"
            level: Access.Technician
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            text: qsTr("All off")
            enabled: section.faults.activeCount > 0
            onClicked: section.faults.clear()
        }
    }
}
