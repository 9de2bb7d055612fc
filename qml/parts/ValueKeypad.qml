// SPDX-License-Identifier: Apache-2.0
// The keypad for one value; a touch beside it cancels.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    required property Value value
    property string label: value.label
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
        label: entry.label
        unit: entry.value.unit
        currentText: entry.value.text
        minimum: entry.value.minimum
        maximum: entry.value.maximum
        defaultValue: entry.value.defaultValue
        decimals: entry.value.decimals
        refusal: isNaN(typedValue) ? "" : entry.value.check(typedValue)
        onAccepted: number => {
            entry.value.set(number)
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
