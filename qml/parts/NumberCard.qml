// SPDX-License-Identifier: Apache-2.0
// One live number on a card: title, number and unit, and a note below. A tap changes the recipe's number, a held finger
// explains.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    required property string title
    property real value: NaN
    property int decimals
    property string unit                   // the metric one
    property string text: Theme.count(card.value * Theme.unitFactor(card.unit), Theme.unitDecimals(card.decimals, card.unit))
    property string note
    property int pixelSize: Theme.size.hero
    property var quantities: []            // those of the number, of Explanations; empty: no explanation
    property string field                  // the recipe's number that a tap changes; empty: none
    property bool tappable: card.quantities.length > 0
    property bool stale: !Controller.fresh
    signal tapped()                        // a number that no field changes

    implicitHeight: Theme.size.touch

    Readout {
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: note.visible ? note.top : parent.bottom; bottomMargin: note.visible ? 0 : Theme.size.accent; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        title: card.title
        titleInset: arrow.visible ? arrow.width : 0
        text: card.text
        unit: Theme.shownUnit(card.unit)
        pixelSize: card.pixelSize
        stale: card.stale
    }
    Label {
        id: note
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; bottom: parent.bottom; bottomMargin: Theme.size.accent }
        visible: text.length > 0
        text: card.note
        color: Controller.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk
        font.pixelSize: Theme.size.caption
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 3
    }
    IconLabel {
        id: arrow
        visible: card.field.length > 0
        anchors { right: parent.right; top: parent.top; margins: Theme.size.spacing }
        code: Theme.icon.next
        opacity: explained.locked ? 0 : 1
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    Explained {
        id: explained
        enabled: card.tappable
        quantities: card.quantities
        field: card.field
        onTapped: card.tapped()
    }
}
