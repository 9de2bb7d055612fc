// SPDX-License-Identifier: Apache-2.0
// The connection to the controller: the simulated one, or a serial port with its parameters. Nothing changes before Connect.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property var parityNames: ({ N: qsTr("None"), E: qsTr("Even"), O: qsTr("Odd") })
    readonly property real half: (width - Theme.size.spacing) / 2

    title: qsTr("Connection")

    Column {
        id: body
        y: section.bodyTop
        width: parent.width
        spacing: Theme.size.spacing
        Segmented {
            objectName: "connectionChoice"
            level: Access.Technician
            width: parent.width
            choices: [{ key: true, text: qsTr("Simulated"), glyph: Theme.icon.simulated },
                { key: false, text: qsTr("Serial port"), glyph: Theme.icon.serialPort }]
            current: Settings.simulated
            onChosen: key => Settings.simulated = key
        }
        Grid {
            width: parent.width
            columns: 2
            spacing: Theme.size.spacing
            visible: !Settings.simulated
            SettingRow {
                objectName: "portButton"
                level: Access.Technician
                width: section.half
                label: qsTr("Port")
                value: Settings.portName.length > 0 ? Settings.portName : qsTr("Choose")
                onClicked: {
                    if (!Access.ask(Access.Technician))
                        return
                    Settings.refreshPorts()
                    Frame.open("Settings/PortPicker", {})
                }
            }
            SettingTile {
                width: section.half
                name: "connection.baud"
            }
            SettingRow {
                width: section.half
                level: Access.Technician
                label: qsTr("Parity and stop bits")
                value: Theme.fill(qsTr("%1, %2"), [section.parityNames[Settings.parity], Settings.stopBits])
                onClicked: if (Access.ask(Access.Technician)) Frame.open("Settings/ParityPicker", {})
            }
            SettingTile {
                width: section.half
                name: "connection.unit"
            }
        }
        Label {
            width: parent.width
            visible: Settings.simulated
            wrapMode: Text.WordWrap
            text: qsTr("The simulated controller runs on this computer and moves no machine. It serves for training and for testing recipes.")
            color: Theme.color.secondaryInk
        }
    }
    IconLabel {
        id: mark
        anchors { left: parent.left; verticalCenter: state.verticalCenter }
        code: Controller.connection === Controller.Connection.Connected ? Theme.icon.linkUp : Theme.icon.linkDown
        color: Theme.color.secondaryInk
    }
    Label {
        id: state
        anchors { left: mark.right; leftMargin: Theme.size.spacing; right: parent.right; bottom: connectButton.top; bottomMargin: Theme.size.spacing }
        height: Math.min(Theme.size.touch, connectButton.y - body.y - body.height - 2 * Theme.size.spacing)
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Controller.connectionText
    }
    Button {
        id: connectButton
        objectName: "connectButton"
        level: Access.Technician
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        text: Settings.connectionDirty ? qsTr("Connect") : qsTr("In use")
        enabled: Settings.connectionDirty && (Settings.simulated || Settings.portName.length > 0)
        onClicked: Settings.applyConnection()
    }
}
