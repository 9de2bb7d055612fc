// SPDX-License-Identifier: Apache-2.0
// A touch area over the derived numbers of a card: a held finger opens their explanation.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

MouseArea {
    id: area

    property var quantities: []            // list of Explanations.Quantity
    property var explained: () => area.quantities // those at this moment

    Accessible.role: Accessible.Button
    Accessible.name: qsTr("How this is calculated")

    anchors.fill: parent
    pressAndHoldInterval: Theme.longPressTime
    onPressAndHold: {
        const quantities = area.explained()
        if (quantities.length > 0)
            Frame.open("Explain/NumbersSheet", { quantities: quantities })
    }
}
