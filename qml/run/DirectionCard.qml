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

    Column {
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: choice.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        Label {
            width: parent.width
            text: qsTr("Master direction")
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.caption - 2
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
    Segmented {
        id: choice
        objectName: "directionChoice"
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        width: Math.round(parent.width * 0.56)
        enabled: card.direction.canChange
        choices: [{ key: MasterDirection.Forward, text: qsTr("Forward"), name: "directionForward" }, { key: MasterDirection.Backward, text: qsTr("Reverse"), name: "directionBackward" }]
        current: card.direction.way
        onChosen: key => card.direction.turn(key)
    }
}
