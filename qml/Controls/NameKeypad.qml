// SPDX-License-Identifier: Apache-2.0
// A keyboard for a part of a register name: small letters, digits, dot and underscore. Every key takes effect at once.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Sheet {
    id: keypad

    property string text
    signal edited(string text)

    readonly property string letters: "abcdefghijklmnopqrstuvwxyz_.0123456789"
    readonly property int perRow: 10
    readonly property real keyWidth: (grid.width - (perRow - 1) * grid.spacing) / perRow
    readonly property real keyHeight: (grid.height - 3 * grid.spacing) / 4

    function type(letter: string): void { keypad.edited(keypad.text + letter) }

    Component.onCompleted: keypad.forceActiveFocus()
    Keys.onReturnPressed: keypad.closed()
    Keys.onPressed: event => {
        if (event.key === Qt.Key_Backspace)
            keypad.edited(keypad.text.slice(0, -1))
        else if (event.text.length === 1 && keypad.letters.includes(event.text.toLowerCase()))
            keypad.type(event.text.toLowerCase())
    }

    Label {
        id: shown
        objectName: "nameText"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        height: Math.round(1.4 * Theme.size.value)
        text: keypad.text.length > 0 ? keypad.text : qsTr("any")
        color: keypad.text.length > 0 ? Theme.color.ink : Theme.color.secondaryInk
        fontSizeMode: Text.HorizontalFit
        font { pixelSize: Theme.size.value; bold: true }
    }
    Grid {
        id: grid
        anchors { left: parent.left; right: parent.right; top: shown.bottom; bottom: parent.bottom; topMargin: Theme.size.spacing }
        columns: keypad.perRow
        spacing: Theme.size.outline
        Repeater {
            model: keypad.letters.length
            KeypadKey {
                required property int index
                objectName: "key_" + text
                width: keypad.keyWidth
                height: keypad.keyHeight
                text: keypad.letters[index]
                onClicked: keypad.type(text)
            }
        }
        KeypadKey {
            width: keypad.keyWidth
            height: keypad.keyHeight
            objectName: "nameBackspace"
            Accessible.name: qsTr("Delete")
            quiet: true
            glyph: Theme.icon.backspace
            enabled: keypad.text.length > 0
            onClicked: keypad.edited(keypad.text.slice(0, -1))
            onPressAndHold: keypad.edited("")
        }
        KeypadKey {
            width: keypad.keyWidth
            height: keypad.keyHeight
            objectName: "nameAccept"
            Accessible.name: qsTr("Confirm")
            primary: true
            glyph: Theme.icon.check
            onClicked: keypad.closed()
        }
    }
}
