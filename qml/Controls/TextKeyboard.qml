// SPDX-License-Identifier: Apache-2.0
// Letters, capitals, digits and signs for a text input elsewhere. The shift key applies to one letter; held, to all. Small
// letters can be pinyin: `pinyin` then has the candidates, also displayed elsewhere.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: keyboard

    required property TextInput input
    property int level                     // of the person who may confirm; 0: everybody
    property bool acceptable: true
    signal accepted()

    enum KeySet { Small, Capital, Signs, Letters }
    property int keySet: TextKeyboard.Small
    property bool capitalsStay

    property bool chinese: Qt.locale().name.startsWith("zh")
    readonly property PinyinInput pinyin: PinyinInput {
        onCommitted: text => keyboard.put(text)
    }
    readonly property bool composing: pinyin.spelling.length > 0

    //: The letters of the language beyond a to z, small and capital, at most 27; - for none.
    readonly property string letters: qsTr("-").replace("-", "")
    readonly property bool hasCapitals: keySet === TextKeyboard.Small || keySet === TextKeyboard.Capital
    readonly property var rows: keySet === TextKeyboard.Letters ? [letters.slice(0, 10), letters.slice(10, 19), letters.slice(19, 27)]
        : keySet === TextKeyboard.Signs ? ["1234567890", "-_/+*=%#&", "().,:;'\"!?"]
        : keySet === TextKeyboard.Capital ? ["QWERTYUIOP", "ASDFGHJKL", "ZXCVBNM"] : ["qwertyuiop", "asdfghjkl", "zxcvbnm"]
    readonly property int perRow: 10
    readonly property real keyWidth: (width - (perRow - 1) * Theme.size.outline) / perRow
    readonly property real keyHeight: (height - 3 * Theme.size.outline) / 4

    function put(letters: string): void {
        keyboard.input.remove(keyboard.input.selectionStart, keyboard.input.selectionEnd)
        keyboard.input.insert(keyboard.input.cursorPosition, letters)
        if (keyboard.keySet === TextKeyboard.Capital && !keyboard.capitalsStay)
            keyboard.keySet = TextKeyboard.Small
    }
    function type(letter: string): void {
        if (keyboard.chinese && keyboard.keySet === TextKeyboard.Small && letter !== "-")
            keyboard.pinyin.add(letter)
        else
            keyboard.put(letter)
    }
    function erase(): void {
        if (keyboard.composing)
            keyboard.pinyin.erase()
        else if (keyboard.input.selectionStart !== keyboard.input.selectionEnd)
            keyboard.input.remove(keyboard.input.selectionStart, keyboard.input.selectionEnd)
        else
            keyboard.input.remove(keyboard.input.cursorPosition - 1, keyboard.input.cursorPosition)
    }

    component Key: KeypadKey {
        width: keyboard.keyWidth
        height: keyboard.keyHeight
        focusPolicy: Qt.NoFocus
    }
    component LetterKey: Key {
        required property string modelData
        objectName: "key_" + modelData
        text: modelData
        onClicked: keyboard.type(modelData)
    }

    Column {
        spacing: Theme.size.outline
        Row {
            spacing: Theme.size.outline
            Repeater {
                model: keyboard.rows[0].split("")
                LetterKey {}
            }
        }
        Row {
            spacing: Theme.size.outline
            Repeater {
                model: keyboard.rows[1].split("")
                LetterKey {}
            }
            Key {
                objectName: "textBackspace"
                Accessible.name: qsTr("Delete")
                quiet: true
                glyph: Theme.icon.backspace
                enabled: keyboard.input.length > 0 || keyboard.composing
                onClicked: keyboard.erase()
                onPressAndHold: {
                    keyboard.pinyin.clear()
                    keyboard.input.clear()
                }
            }
        }
        Row {
            spacing: Theme.size.outline
            Key {
                objectName: "textCapital"
                Accessible.name: qsTr("Capital letters")
                visible: keyboard.hasCapitals
                width: 1.5 * keyboard.keyWidth + Theme.size.outline / 2
                quiet: true
                primary: keyboard.keySet === TextKeyboard.Capital && keyboard.capitalsStay
                glyph: Theme.icon.capital
                onClicked: {
                    keyboard.pinyin.clear()
                    keyboard.capitalsStay = false
                    keyboard.keySet = keyboard.keySet === TextKeyboard.Capital ? TextKeyboard.Small : TextKeyboard.Capital
                }
                onPressAndHold: {
                    keyboard.pinyin.clear()
                    keyboard.keySet = TextKeyboard.Capital
                    keyboard.capitalsStay = true
                }
            }
            Repeater {
                model: keyboard.rows[2].split("")
                LetterKey {}
            }
            Key {
                visible: keyboard.hasCapitals
                width: 1.5 * keyboard.keyWidth + Theme.size.outline / 2
                objectName: "key_-"
                text: "-"
                onClicked: keyboard.put("-")
            }
        }
        Row {
            spacing: Theme.size.outline
            Key {
                objectName: "textSigns"
                width: 2 * keyboard.keyWidth + Theme.size.outline
                quiet: true
                readonly property int nextSet: keyboard.hasCapitals ? TextKeyboard.Signs
                    : keyboard.keySet === TextKeyboard.Signs && keyboard.letters.length > 0 ? TextKeyboard.Letters : TextKeyboard.Small
                text: nextSet === TextKeyboard.Signs ? qsTr("123") : nextSet === TextKeyboard.Letters ? keyboard.letters.slice(0, 3) : qsTr("abc")
                onClicked: {
                    keyboard.pinyin.clear()
                    keyboard.keySet = nextSet
                }
            }
            Key {
                objectName: "textChinese"
                visible: keyboard.pinyin.available
                width: 1.5 * keyboard.keyWidth + Theme.size.outline / 2
                quiet: true
                text: keyboard.chinese ? "中" : "EN"
                onClicked: {
                    keyboard.pinyin.clear()
                    keyboard.chinese = !keyboard.chinese
                }
            }
            Key {
                objectName: "textSpace"
                width: (keyboard.pinyin.available ? 4.5 : 6) * keyboard.keyWidth + (keyboard.pinyin.available ? 3.5 : 5) * Theme.size.outline
                text: keyboard.composing ? keyboard.pinyin.candidates[0] ?? "" : qsTr("Space")
                onClicked: if (keyboard.composing) keyboard.pinyin.choose(0); else keyboard.put(" ")
            }
            Key {
                objectName: "textAccept"
                level: keyboard.level
                Accessible.name: qsTr("Confirm")
                width: 2 * keyboard.keyWidth + Theme.size.outline
                primary: true
                glyph: Theme.icon.check
                enabled: keyboard.acceptable || keyboard.composing
                onClicked: if (keyboard.composing) keyboard.pinyin.choose(0); else keyboard.accepted()
            }
        }
    }
}
