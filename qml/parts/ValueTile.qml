// SPDX-License-Identifier: Apache-2.0
// One of the controller's numbers with its label: `value` is the name of its register, which has the unit.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: tile
    Accessible.role: Accessible.StaticText
    Accessible.name: tile.label
    Accessible.description: tile.text

    property string value
    required property string label
    property string text: tile.known(Theme.units)
    property real labelSize: Theme.size.body
    property real amountSize: Theme.size.body

    // `units` are those that the binding depends on.
    function known(units: var): string { return Controller.telemetry.text(tile.value, Controller.telemetry[tile.value]) }

    implicitHeight: amount.implicitHeight

    Label {
        anchors { left: parent.left; right: amount.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        text: tile.label
        fontSizeMode: Text.HorizontalFit
        color: tile.labelSize < tile.amountSize ? Theme.color.secondaryInk : Theme.color.ink
        font.pixelSize: tile.labelSize
    }
    Label {
        id: amount
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        text: tile.text
        color: Controller.fresh && Controller.packing.fresh ? Theme.color.ink : Theme.color.disabledInk
        font { pixelSize: tile.amountSize; bold: true }
    }
}
