// SPDX-License-Identifier: Apache-2.0
// Over the derived numbers of a card: a finger that is held there asks how they come about.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

MouseArea {
    id: area

    required property var quantities       // list of Explanations.Quantity
    signal explainRequested(var quantities)

    anchors.fill: parent
    pressAndHoldInterval: Theme.longPressTime
    onPressAndHold: area.explainRequested(area.quantities)
}
