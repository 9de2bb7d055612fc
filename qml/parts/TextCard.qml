// SPDX-License-Identifier: Apache-2.0
// One large live text with its name below.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    required property string text
    required property string caption
    property color captionColor: Theme.color.secondaryInk
    property var quantities: []            // the quantity of the text, of Explanations; empty: no explanation
    property string field                  // the recipe's number that a tap changes; empty: none

    Readout {
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; verticalCenterOffset: -Theme.size.padding }
        text: card.text
        stale: !Controller.fresh
    }
    Label {
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        text: card.caption
        color: card.captionColor
        font.pixelSize: Theme.size.body
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 3
    }
    IconLabel {
        visible: card.field.length > 0
        anchors { right: parent.right; top: parent.top; margins: Theme.size.spacing }
        code: Theme.icon.edit
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    Explained {
        enabled: card.quantities.length > 0
        quantities: card.quantities
        field: card.field
    }
}
