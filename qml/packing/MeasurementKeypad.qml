// SPDX-License-Identifier: Apache-2.0
// The keypad for the distance of a cut behind its mark, for the wizard of the sensor's distance.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: entry

    readonly property MarkWizard wizard: Service.packing.wizard
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
        label: qsTr("Cut offset behind its mark")
        unit: "mm"
        currentText: Theme.number(NaN, 2)
        minimum: -entry.wizard.mostMm
        maximum: entry.wizard.mostMm
        defaultValue: 0
        decimals: 2
        refusal: isNaN(typedValue) ? "" : entry.wizard.check(typedValue)
        onAccepted: value => {
            entry.wizard.addMeasurement(value)
            entry.closed()
        }
        onCanceled: entry.closed()
    }
}
