// SPDX-License-Identifier: Apache-2.0
// The purpose of a PIN or an address on the left, and its pad beside Stop.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Overlay {
    id: panel

    required property string title
    property string sentence
    property alias pad: pad
    default property alias content: body.data

    // Forgets the digits of somebody who was logged out. What else is pending stays.
    function forget(): void { pad.clear() }

    pending: pad.digits.length > 0
    secret: true

    Rectangle {
        anchors.fill: parent
        color: Theme.color.scrim
    }
    MouseArea { anchors.fill: parent }
    Connections {
        target: pad
        function onDigitsChanged() { panel.warned = false }
    }
    Card {
        objectName: "sheetPanel"
        clip: true
        anchors { left: parent.left; leftMargin: Theme.size.gap; right: pad.left; rightMargin: Theme.size.spacing; top: pad.top; bottom: pad.bottom }
        MouseArea { anchors.fill: parent }
        Column {
            id: heading
            anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding }
            spacing: Theme.size.spacing
            Label {
                width: parent.width
                text: panel.title
                wrapMode: Text.WordWrap
                font { pixelSize: Theme.size.title; bold: true }
            }
            Label {
                objectName: "pinSentence"
                width: parent.width
                visible: text.length > 0
                wrapMode: Text.Wrap         // paths have no spaces
                text: panel.sentence
                color: Theme.color.secondaryInk
            }
        }
        Item {
            id: body
            anchors { left: parent.left; right: parent.right; top: heading.bottom; bottom: parent.bottom; margins: Theme.size.padding }
        }
    }
    DigitPad {
        id: pad
        objectName: "keypad"
        label: panel.title
        warning: panel.warning
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        width: preferredWidth
        height: Math.min(parent.height, preferredHeight)
        onCanceled: panel.closed()
    }
}
