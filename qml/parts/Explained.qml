// SPDX-License-Identifier: Apache-2.0
// A touch area over the derived numbers of a card: a held finger requests their explanation.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

MouseArea {
    id: area

    required property var quantities       // list of Explanations.Quantity
    signal explainRequested(var quantities)

    Accessible.role: Accessible.Button
    Accessible.name: qsTr("How this is calculated")

    anchors.fill: parent
    pressAndHoldInterval: Theme.longPressTime
    onPressAndHold: area.explainRequested(area.quantities)
}
