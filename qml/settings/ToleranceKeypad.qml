// SPDX-License-Identifier: Apache-2.0
// The keypad for the tolerance of a bag's length.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    readonly property int decimals: 2
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
        label: qsTr("Bag tolerance ±")
        unit: "mm"
        currentText: Theme.number(Settings.bagToleranceMm, entry.decimals)
        minimum: Settings.leastBagToleranceMm
        maximum: Settings.mostBagToleranceMm
        defaultValue: Settings.defaultBagToleranceMm
        decimals: entry.decimals
        refusal: isNaN(typedValue) || (typedValue >= minimum && typedValue <= maximum) ? ""
            : qsTr("The tolerance must be from %1 to %2 mm.").arg(Theme.number(minimum, entry.decimals)).arg(Theme.number(maximum, entry.decimals))
        onAccepted: value => {
            Settings.bagToleranceMm = value
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
