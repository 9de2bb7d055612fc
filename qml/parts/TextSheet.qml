// SPDX-License-Identifier: Apache-2.0
// The entry of a text: its purpose above the keyboard, and below it why the present text is not valid.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property string text                   // initial text
    property var check: text => ""         // function: why that text is not valid
    property string problem: sheet.check.call(sheet, input.text) // empty: valid
    property bool acceptable: problem.length === 0
    property int level: Access.Viewer      // needed to confirm: the user may be logged out meanwhile
    property bool holds                    // what was chosen in a step before
    property string first                  // the text at the opening
    property bool insisted                 // somebody wants to confirm what is not valid
    readonly property bool touched: input.text !== first || insisted
    signal edited(string text)
    signal accepted(string text)

    function accept(): void {
        sheet.insisted = !sheet.acceptable
        if (sheet.insisted || !Access.ask(sheet.level))
            return
        sheet.first = input.text // nothing is pending any more
        sheet.holds = false
        sheet.accepted(input.text)
        sheet.closed()
    }

    function fill(text: string): void {
        input.text = text
    }

    pending: sheet.holds || input.text !== first || keyboard.composing
    Component.onCompleted: {
        sheet.first = sheet.text
        input.text = sheet.text
        input.selectAll()
        input.forceActiveFocus()
    }

    Rectangle {
        id: field
        anchors { left: parent.left; top: parent.top }
        width: keyboard.composing ? Math.round(parent.width / 3) : parent.width
        // Leaves the height of a letter key for this and the problem below.
        height: Math.max(Math.round(1.5 * Theme.size.value), Math.ceil(Theme.size.touch / Theme.size.reach) - problemLabel.height)
        radius: Theme.size.radius
        color: Theme.color.inset
        border { width: Theme.size.outline; color: problemLabel.text.length === 0 ? Theme.color.touch : Theme.color.warning }
        TextInput {
            id: input
            objectName: "textInput"
            Accessible.role: Accessible.EditableText
            Accessible.name: sheet.title
            anchors { fill: parent; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding }
            verticalAlignment: TextInput.AlignVCenter
            clip: true
            color: Theme.color.ink
            selectionColor: Theme.color.touchTint
            selectedTextColor: Theme.color.ink
            font { pixelSize: Theme.size.title; bold: true }
            inputMethodHints: Qt.ImhNoPredictiveText
            focus: true
            onTextChanged: {
                sheet.warned = false
                sheet.asked = false
                sheet.insisted = false
                sheet.edited(text)
            }
            onAccepted: sheet.accept()
        }
    }
    // The candidates of the pinyin letters, beside the field.
    Item {
        anchors { left: field.right; leftMargin: Theme.size.spacing; right: parent.right; top: field.top; bottom: problemLabel.bottom }
        visible: keyboard.composing
        Label {
            id: spelling
            objectName: "pinyinSpelling"
            anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
            width: Math.min(implicitWidth, parent.width / 3)
            verticalAlignment: Text.AlignVCenter
            elide: Text.ElideLeft
            text: keyboard.pinyin.spelling
            color: Theme.color.touch
        }
        ListView {
            anchors { left: spelling.right; leftMargin: Theme.size.spacing; right: parent.right; top: parent.top; bottom: parent.bottom }
            orientation: ListView.Horizontal
            boundsBehavior: Flickable.StopAtBounds
            clip: true
            model: keyboard.pinyin.candidates
            delegate: KeypadKey {
                required property string modelData
                required property int index
                objectName: "key_candidate" + index
                width: Math.max(Theme.size.touch, Theme.size.value * (modelData.length + 1))
                height: ListView.view.height
                focusPolicy: Qt.NoFocus
                text: modelData
                onClicked: keyboard.pinyin.choose(index)
            }
        }
    }
    Label {
        id: problemLabel
        objectName: "textProblem"
        visible: !keyboard.composing
        anchors { left: parent.left; right: parent.right; top: field.bottom }
        height: Math.round(1.6 * Theme.size.caption)
        text: sheet.touched ? sheet.problem : ""
        color: Theme.color.warning
        fontSizeMode: Text.HorizontalFit
        font.pixelSize: Theme.size.caption
    }
    TextKeyboard {
        id: keyboard
        anchors { left: parent.left; right: parent.right; top: problemLabel.bottom; bottom: parent.bottom }
        input: input
        acceptable: sheet.acceptable
        level: sheet.level
        onAccepted: sheet.accept()
    }
}
