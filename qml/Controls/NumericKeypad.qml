// SPDX-License-Identifier: Apache-2.0
// Numeric keypad with unit, limits, current and default value. A value outside the limits is refused here, with the limit.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Card {
    id: keypad

    required property string label
    required property string unit
    required property string currentText
    required property real minimum
    required property real maximum
    property real possible: NaN            // the largest number that works with the others
    required property real defaultValue
    required property int decimals
    property string refusal                // reason why typedValue is refused; "" when it is valid
    property int level                     // of the person who may confirm; 0: everybody
    property string warning                // instead of the limits while something is typed
    signal edited()
    signal accepted()
    signal canceled()

    // The height at which keys are 18 mm and the header has room.
    readonly property int preferredHeight: 4 * Theme.size.commandKey + Theme.size.touch + Theme.size.padding
    readonly property int keyWidth: Math.min(Theme.size.commandKey, Math.floor((width - 2 * Theme.size.accent) / 4))
    readonly property int keyHeight: Math.min(Theme.size.commandKey, Math.floor((height - header.height - Theme.size.spacing - Theme.size.accent) / 4))
    readonly property real typedValue: entry.value
    readonly property bool pending: !entry.empty
    readonly property bool acceptable: entry.complete && refusal.length === 0
    property bool insisted                 // somebody wants to confirm what is not valid
    // A number that more digits can make valid is not refused yet.
    readonly property bool refused: entry.text.length > 0 && refusal.length > 0 && (insisted || warning.length > 0 || !entry.canBecome(minimum, maximum))

    function clear(): void { entry.clear() }
    function finish(): void {
        if (keypad.acceptable)
            keypad.accepted()
        else
            keypad.insisted = true
    }

    border { width: Theme.size.outline; color: Theme.color.touch }
    focus: true
    Component.onCompleted: keypad.forceActiveFocus()
    Keys.onReturnPressed: keypad.finish()
    Keys.onEnterPressed: keypad.finish()
    Keys.onPressed: event => entry.type(event.text)

    MouseArea { anchors.fill: parent }
    NumberEntry {
        id: entry
        decimals: keypad.decimals
        locale: Theme.language
        onChanged: {
            keypad.insisted = false
            keypad.edited()
        }
    }
    Item {
        id: header
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding; topMargin: Math.max(Theme.size.spacing, Theme.size.accent) }
        height: Math.max(Math.round(1.3 * (Theme.size.value + Theme.size.caption)), keypad.height - 4 * Theme.size.commandKey - 2 * Theme.size.accent - Theme.size.spacing)

        Label {
            id: caption
            anchors { left: parent.left; right: shown.left; rightMargin: Theme.size.spacing; top: parent.top }
            text: keypad.label
            fontSizeMode: Text.HorizontalFit
            font { weight: Font.DemiBold; pixelSize: Theme.size.body }
        }
        Label {
            id: shown
            objectName: "keypadText"
            anchors { right: suffix.left; rightMargin: Theme.size.spacing; top: parent.top; topMargin: -Theme.size.accent }
            text: entry.empty ? keypad.currentText : entry.text
            color: entry.empty ? Theme.color.disabledInk : keypad.refused ? Theme.color.fault : Theme.color.ink
            font { pixelSize: Theme.size.value; bold: true }
        }
        Label {
            id: suffix
            anchors { right: parent.right; baseline: shown.baseline }
            text: keypad.unit
            color: Theme.color.secondaryInk
        }
        Label {
            objectName: "keypadHint"
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom; top: shown.bottom }
            fontSizeMode: Text.Fit
            wrapMode: Text.WordWrap
            text: entry.unwantedFraction ? qsTr("Enter a whole number.") : keypad.refused ? keypad.refusal
                : keypad.warning.length > 0 ? keypad.warning
                : keypad.possible < keypad.maximum ? Theme.fill(qsTr("%1 to %2, possible up to %3 · now %4"), [Theme.number(keypad.minimum, keypad.decimals), Theme.number(keypad.maximum, keypad.decimals), Theme.number(keypad.possible, keypad.decimals), keypad.currentText])
                : Theme.fill(qsTr("%1 to %2 · now %3"), [Theme.number(keypad.minimum, keypad.decimals), Theme.number(keypad.maximum, keypad.decimals), keypad.currentText])
            color: keypad.refused || entry.unwantedFraction ? Theme.color.fault : keypad.warning.length > 0 ? Theme.color.warning : Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Grid {
        anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: Theme.size.hairline }
        columns: 4

        component Digit: KeypadKey {
            width: keypad.keyWidth
            height: keypad.keyHeight
            onClicked: entry.type(text)
        }
        Digit { text: "7" }
        Digit { text: "8" }
        Digit { text: "9" }
        KeypadKey {
            width: keypad.keyWidth; height: keypad.keyHeight
            objectName: "keypadBackspace"
            Accessible.name: qsTr("Delete")
            quiet: true
            glyph: Theme.icon.backspace
            enabled: !entry.empty
            onClicked: entry.backspace()
            onPressAndHold: entry.clear()
        }
        Digit { text: "4" }
        Digit { text: "5" }
        Digit { text: "6" }
        KeypadKey {
            width: keypad.keyWidth; height: keypad.keyHeight
            objectName: "keypadDefault"
            quiet: true
            text: Theme.number(keypad.defaultValue, keypad.decimals)
            note: qsTr("Default")
            onClicked: entry.setValue(keypad.defaultValue)
        }
        Digit { text: "1" }
        Digit { text: "2" }
        Digit { text: "3" }
        KeypadKey {
            width: keypad.keyWidth; height: keypad.keyHeight
            objectName: "keypadCancel"
            quiet: true
            glyph: Theme.icon.close
            text: qsTr("Cancel")
            onClicked: keypad.canceled()
        }
        Digit { text: "0" }
        Digit { text: entry.decimalPoint; enabled: keypad.decimals > 0 }
        Digit { text: "−"; enabled: keypad.minimum < 0 }
        KeypadKey {
            width: keypad.keyWidth; height: keypad.keyHeight
            objectName: "keypadAccept"
            level: keypad.level
            primary: true
            glyph: Theme.icon.check
            text: qsTr("OK")
            enabled: keypad.acceptable
            onClicked: keypad.finish()
        }
    }
}
