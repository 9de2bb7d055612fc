// SPDX-License-Identifier: Apache-2.0
// Parity and stop bits of the serial line.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    title: qsTr("Parity and stop bits")
    panelWidth: width * 0.7
    panelHeight: 4 * Theme.size.touch + 4 * Theme.size.padding

    Column {
        width: parent.width
        spacing: Theme.size.padding
        Segmented {
            width: parent.width
            level: Access.Technician
            choices: [{ key: "N", text: qsTr("None") }, { key: "E", text: qsTr("Even") }, { key: "O", text: qsTr("Odd") }]
            current: Settings.parity
            onChosen: key => Settings.parity = key
        }
        Segmented {
            width: parent.width
            level: Access.Technician
            choices: [{ key: 1, text: qsTr("1 stop bit") }, { key: 2, text: qsTr("2 stop bits") }]
            current: Settings.stopBits
            onChosen: key => Settings.stopBits = key
        }
    }
}
