// SPDX-License-Identifier: Apache-2.0
// The direction of a cam's master, with the choice of the other one, also during a run. The selected choice is the
// controller's setting, not the last touch.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    readonly property MasterDirection direction: Controller.direction

    implicitHeight: Theme.size.touch + 2 * Theme.size.spacing

    // Turns a running axis around, and is held like every such key.
    component Way: CommandButton {
        id: key
        required property int way
        readonly property bool selected: card.direction.way === way
        readonly property color ink: !enabled ? Theme.color.disabledInk : selected ? Theme.color.touch : Theme.color.secondaryInk
        width: Math.round(card.width * 0.28)
        height: Theme.size.touch
        ready: !selected
        level: Access.Technician
        onCommanded: card.direction.turn(way)
        background: Rectangle {
            radius: Theme.size.radius
            color: key.selected || key.down ? Theme.color.touchTint : Theme.color.inset
            border { width: key.selected ? Theme.size.outline : Theme.size.hairline; color: !key.selected ? Theme.color.line : key.enabled ? Theme.color.touch : Theme.color.disabledInk }
        }
        Column {
            anchors.centerIn: parent
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                width: Math.min(implicitWidth, key.width - Theme.size.accent)
                fontSizeMode: Text.HorizontalFit
                text: key.text
                color: key.ink
                font { pixelSize: Theme.size.body; weight: key.selected ? Font.Bold : Font.DemiBold }
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                width: Math.min(implicitWidth, key.width - Theme.size.accent)
                visible: !key.selected
                fontSizeMode: Text.HorizontalFit
                text: key.holdNote
                color: key.ink
                font.pixelSize: Theme.size.caption
            }
        }
    }

    Column {
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: choice.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        Label {
            width: parent.width
            text: qsTr("Master direction")
            fontSizeMode: Text.HorizontalFit
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            objectName: "directionText"
            width: parent.width
            text: card.direction.text
            wrapMode: Text.WordWrap
            color: !Controller.fresh ? Theme.color.disabledInk : card.direction.turning ? Theme.color.warning : card.direction.canChange ? Theme.color.ink : Theme.color.secondaryInk
            font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
        }
    }
    Row {
        id: choice
        objectName: "directionChoice"
        enabled: card.direction.canChange
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        Way {
            objectName: "directionForward"
            way: MasterDirection.Forward
            text: qsTr("Forward")
        }
        Way {
            objectName: "directionBackward"
            way: MasterDirection.Backward
            text: qsTr("Reverse")
        }
    }
}
