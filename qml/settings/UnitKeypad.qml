// SPDX-License-Identifier: Apache-2.0
// The unit number of the controller on the line.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    readonly property int lowest: 1        // Modbus: 0 is broadcast, above 247 is reserved
    readonly property int highest: 247
    signal closed()

    MouseArea {
        anchors.fill: parent
        onClicked: entry.closed()
    }
    NumericKeypad {
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        width: 4 * Theme.size.commandKey + 2 * Theme.size.accent
        height: Math.min(parent.height, preferredHeight)
        label: qsTr("Unit number")
        unit: ""
        currentText: Settings.unit
        minimum: entry.lowest
        maximum: entry.highest
        defaultValue: entry.lowest
        decimals: 0
        refusal: isNaN(typedValue) || (typedValue >= minimum && typedValue <= maximum) ? ""
            : qsTr("The unit number must be from %1 to %2.").arg(minimum).arg(maximum)
        onAccepted: value => {
            Settings.unit = value
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
