// SPDX-License-Identifier: Apache-2.0
// Digits that are no number: a PIN, displayed as dots, or an address with points. The keys are those of the numeric keypad.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Card {
    id: pad

    required property string label
    property string hint
    property bool hintIsFault
    property string warning                // instead of the hint
    property bool ready: true              // digits may be entered
    property int level                     // of the person who may confirm; 0: everybody
    property bool secret: true
    property bool pointed                  // with a key for the point
    property int most: 8
    property int fewest: 4
    signal accepted(string digits)
    signal edited()
    signal canceled()

    property string digits

    readonly property int preferredWidth: 4 * Theme.size.commandKey + 2 * Theme.size.accent
    readonly property int preferredHeight: 4 * Theme.size.commandKey + Theme.size.touch + Theme.size.padding
    readonly property int keyWidth: Math.min(Theme.size.commandKey, Math.floor((width - 2 * Theme.size.accent) / 4))
    readonly property int keyHeight: Math.min(Theme.size.commandKey, Math.floor((height - header.height - Theme.size.spacing - Theme.size.accent) / 4))
    readonly property bool acceptable: ready && digits.length >= fewest

    function clear(): void { pad.digits = "" }
    function type(key: string): void {
        if (pad.digits.length < pad.most && key.length === 1 && (pad.pointed ? "0123456789." : "0123456789").includes(key)) {
            pad.digits += key
            pad.edited()
        }
    }
    function backspace(): void { pad.digits = pad.digits.slice(0, -1) }
    function finish(): void {
        if (!pad.acceptable)
            return
        const digits = pad.digits
        pad.clear()
        pad.accepted(digits)
    }

    border { width: Theme.size.outline; color: Theme.color.touch }
    focus: true
    Component.onCompleted: pad.forceActiveFocus()
    Keys.onReturnPressed: pad.finish()
    Keys.onEnterPressed: pad.finish()
    Keys.onPressed: event => {
        if (event.key === Qt.Key_Backspace)
            pad.backspace()
        else
            pad.type(event.text)
    }

    MouseArea { anchors.fill: parent }
    Item {
        id: header
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding; topMargin: Math.max(Theme.size.spacing, Theme.size.accent) }
        height: Math.max(Math.round(1.3 * (Theme.size.value + Theme.size.caption)), pad.height - 4 * Theme.size.commandKey - 2 * Theme.size.accent - Theme.size.spacing)

        Label {
            id: caption
            anchors { left: parent.left; right: dots.left; rightMargin: Theme.size.spacing; verticalCenter: dots.verticalCenter }
            text: pad.label
            fontSizeMode: Text.HorizontalFit
            font { weight: Font.DemiBold; pixelSize: Theme.size.body }
        }
        Row {
            id: dots
            objectName: "pinDots"
            anchors { right: parent.right; top: parent.top; topMargin: Theme.size.accent }
            height: Theme.size.value
            spacing: Theme.size.accent
            Label {
                objectName: "padText"
                visible: !pad.secret
                anchors.verticalCenter: parent.verticalCenter
                text: pad.digits
                color: pad.hintIsFault ? Theme.color.fault : Theme.color.ink
                font { pixelSize: Theme.size.title; bold: true }
            }
            Repeater {
                model: pad.secret ? pad.digits.length : 0
                Rectangle {
                    anchors.verticalCenter: parent.verticalCenter
                    width: Theme.size.mark
                    height: width
                    radius: width / 2
                    color: Theme.color.ink
                }
            }
        }
        Label {
            objectName: "pinHint"
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom; top: dots.bottom }
            fontSizeMode: Text.Fit
            wrapMode: Text.WordWrap
            text: pad.warning.length > 0 ? pad.warning : pad.hint
            color: pad.warning.length > 0 ? Theme.color.warning : pad.hintIsFault ? Theme.color.fault : Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Grid {
        anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: Theme.size.hairline }
        columns: 4

        component Digit: KeypadKey {
            objectName: "pin" + text
            width: pad.keyWidth
            height: pad.keyHeight
            onClicked: pad.type(text)
        }
        Digit { text: "7" }
        Digit { text: "8" }
        Digit { text: "9" }
        KeypadKey {
            width: pad.keyWidth; height: pad.keyHeight
            objectName: "pinBackspace"
            Accessible.name: qsTr("Delete")
            quiet: true
            glyph: Theme.icon.backspace
            enabled: pad.digits.length > 0
            onClicked: pad.backspace()
            onPressAndHold: pad.clear()
        }
        Digit { text: "4" }
        Digit { text: "5" }
        Digit { text: "6" }
        Item { width: pad.keyWidth; height: pad.keyHeight }
        Digit { text: "1" }
        Digit { text: "2" }
        Digit { text: "3" }
        KeypadKey {
            width: pad.keyWidth; height: pad.keyHeight
            objectName: "pinCancel"
            quiet: true
            glyph: Theme.icon.close
            text: qsTr("Cancel")
            onClicked: pad.canceled()
        }
        Item {
            width: pad.keyWidth; height: pad.keyHeight
            Digit {
                visible: pad.pointed
                text: "."
            }
        }
        Digit { text: "0" }
        Item { width: pad.keyWidth; height: pad.keyHeight }
        KeypadKey {
            width: pad.keyWidth; height: pad.keyHeight
            objectName: "pinAccept"
            level: pad.level
            primary: true
            glyph: Theme.icon.check
            text: qsTr("OK")
            enabled: pad.acceptable
            onClicked: pad.finish()
        }
    }
}
