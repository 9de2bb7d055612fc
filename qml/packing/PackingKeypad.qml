// SPDX-License-Identifier: Apache-2.0
// The new value of the selected number of the packing machine.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    readonly property PackingFields fields: Service.packing.fields
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
        label: entry.fields.label
        unit: entry.fields.unit
        currentText: entry.fields.valueText
        minimum: entry.fields.minimum
        maximum: entry.fields.maximum
        defaultValue: entry.fields.defaultValue
        decimals: entry.fields.decimals
        refusal: isNaN(typedValue) ? "" : entry.fields.check(typedValue)
        onAccepted: value => {
            entry.fields.writeSelected(value)
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
