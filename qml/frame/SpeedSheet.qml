// SPDX-License-Identifier: Apache-2.0
// Slower and faster while the machine runs. It stays open, for the next step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    objectName: "speedSheet"
    title: qsTr("Speed")
    note: HandSpeed.message || qsTr("Of the program's rate. A slower machine seals longer.")
    panelWidth: Math.min(width * 0.86, 6 * Theme.size.commandKey)
    panelHeight: 2.5 * Theme.size.touch + 2 * Theme.size.commandKey + 4 * Theme.size.padding

    Readout {
        id: number
        objectName: "speedPercent"
        anchors { left: parent.left; top: parent.top; bottom: keys.top }
        width: Math.round(parent.width * 0.4)
        pixelSize: Theme.size.hero
        text: Theme.count(HandSpeed.percent, 0)
        unit: "%"
        ink: HandSpeed.percent < 100 ? Theme.color.warning : Theme.color.ink
        stale: !Controller.fresh
    }
    Label {
        objectName: "speedRate"
        anchors { left: number.right; right: parent.right; verticalCenter: number.verticalCenter }
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: HandSpeed.rateText
        color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
        font.pixelSize: Theme.size.value
    }
    Row {
        id: keys
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.gap
        readonly property real keyWidth: (width - 2 * spacing) / 3
        component Step: StepButton {
            width: keys.keyWidth
            height: Theme.size.commandKey
            level: Access.Operator
        }
        Step {
            objectName: "speedSlower"
            text: qsTr("Slower")
            note: "−5 %"
            enabled: HandSpeed.canSlower
            onClicked: HandSpeed.slower()
        }
        Step {
            objectName: "speedFull"
            text: "100 %"
            enabled: HandSpeed.canFaster
            onClicked: HandSpeed.full()
        }
        Step {
            objectName: "speedFaster"
            text: qsTr("Faster")
            note: "+5 %"
            enabled: HandSpeed.canFaster
            onClicked: HandSpeed.faster()
        }
    }
}
