// SPDX-License-Identifier: Apache-2.0
// The pulse frequency of jogging or homing.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    required property AxisSpeed speed
    signal closed()

    MouseArea {
        anchors.fill: parent
        onClicked: entry.closed()
    }
    NumericKeypad {
        objectName: "keypad"
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        width: 4 * Theme.size.commandKey + 2 * Theme.size.accent
        height: Math.min(parent.height, preferredHeight)
        label: entry.speed.label
        unit: "Hz"
        currentText: Theme.number(entry.speed.frequencyHz, 0)
        minimum: entry.speed.minimum
        maximum: entry.speed.maximum
        defaultValue: entry.speed.defaultValue
        decimals: 0
        refusal: isNaN(typedValue) || (typedValue >= minimum && typedValue <= maximum) ? ""
            : qsTr("The frequency must be from %1 to %2 Hz.").arg(Theme.number(minimum, 0)).arg(Theme.number(maximum, 0))
        onAccepted: value => {
            entry.speed.write(value)
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
