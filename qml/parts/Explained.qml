// SPDX-License-Identifier: Apache-2.0
// A touch area over the numbers of a card: a held finger opens their explanation, and a tap the keypad of the recipe's
// number behind them, with its download.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

MouseArea {
    id: area

    property var quantities: []            // list of Explanations.Quantity
    property var explained: () => area.quantities // those at this moment
    property string field                  // name of the recipe's number; empty: a tap does nothing

    signal tapped()                        // without such a number

    readonly property bool locked: area.field.length > 0 && Editor.field(area.field).neededLevel > Permission.level // in place of the pencil

    Accessible.role: Accessible.Button
    Accessible.name: area.field.length > 0 ? Theme.fill(qsTr("Change: %1"), [change.nameOf(area.field)]) : qsTr("How this is calculated")

    anchors.fill: parent
    pressAndHoldInterval: Theme.longPressTime
    onClicked: {
        if (area.field.length === 0) {
            area.tapped()
            return
        }
        Permission.tap(area, () => change.begin(area.field))
        change.begin(area.field)
    }
    onPressAndHold: {
        const quantities = area.explained()
        if (quantities.length > 0)
            Frame.open("Explain/NumbersSheet", { quantities: quantities })
    }
    Padlock {
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        visible: area.locked
    }
    ProgramChange { id: change }
}
