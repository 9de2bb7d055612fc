// SPDX-License-Identifier: Apache-2.0
// The new value of the selected register.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    readonly property RegisterInspector inspector: Service.inspector
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
        label: entry.inspector.selectedName
        unit: entry.inspector.unit
        currentText: entry.inspector.valueText
        minimum: entry.inspector.minimum
        maximum: entry.inspector.maximum
        defaultValue: entry.inspector.defaultValue
        decimals: entry.inspector.decimals
        refusal: isNaN(typedValue) ? "" : entry.inspector.check(typedValue)
        onAccepted: value => {
            entry.inspector.write(value)
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
