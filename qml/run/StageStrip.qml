// SPDX-License-Identifier: Apache-2.0
// The five stages of a press stroke; the present one is tinted, framed and bold.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Row {
    id: strip

    spacing: Theme.size.spacing

    Repeater {
        model: Controller.stageNames
        Card {
            id: stage
            required property string modelData
            required property int index
            readonly property bool current: Controller.live.stage === index
            objectName: "stage" + index
            width: (strip.width - 4 * strip.spacing) / 5
            height: strip.height
            color: current && Controller.fresh ? Theme.color.touchTint : Theme.color.surface
            border { width: current ? Theme.size.outline : 0; color: Controller.fresh ? Theme.color.touch : Theme.color.target }
            Label {
                anchors { fill: parent; margins: Theme.size.accent }
                horizontalAlignment: Text.AlignHCenter
                fontSizeMode: Text.HorizontalFit
                text: (stage.index + 1) + "  " + stage.modelData
                color: !Controller.fresh ? Theme.color.disabledInk : stage.current ? Theme.color.ink : Theme.color.secondaryInk
                font.weight: stage.current ? Font.Bold : Font.Normal
            }
        }
    }
}
