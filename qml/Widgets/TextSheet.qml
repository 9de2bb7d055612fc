// SPDX-License-Identifier: Apache-2.0
// A text to be entered: what it is above the keyboard, and below it why it cannot be taken as it stands.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Sheet {
    id: sheet

    property string text                   // at the beginning
    property string problem                // empty: can be taken
    property bool acceptable: problem.length === 0
    signal edited(string text)
    signal accepted()

    function accept(): void {
        if (sheet.acceptable)
            sheet.accepted()
    }

    Component.onCompleted: {
        input.text = sheet.text
        input.selectAll()
        input.forceActiveFocus()
    }

    Rectangle {
        id: field
        anchors { left: parent.left; right: parent.right; top: parent.top }
        height: Math.round(1.5 * Theme.size.value)
        radius: Theme.size.radius
        color: Theme.color.inset
        border { width: Theme.size.outline; color: sheet.acceptable ? Theme.color.touch : Theme.color.warning }
        TextInput {
            id: input
            objectName: "textInput"
            anchors { fill: parent; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding }
            verticalAlignment: TextInput.AlignVCenter
            clip: true
            color: Theme.color.ink
            selectionColor: Theme.color.touchTint
            selectedTextColor: Theme.color.ink
            font { pixelSize: Theme.size.title; bold: true }
            inputMethodHints: Qt.ImhNoPredictiveText
            onTextChanged: sheet.edited(text)
            onAccepted: sheet.accept()
            Keys.onEscapePressed: sheet.closed()
        }
    }
    Label {
        id: problemLabel
        objectName: "textProblem"
        anchors { left: parent.left; right: parent.right; top: field.bottom }
        height: Math.round(1.6 * Theme.size.caption)
        text: sheet.problem
        color: Theme.color.warning
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 3
        font.pixelSize: Theme.size.caption
    }
    TextKeyboard {
        anchors { left: parent.left; right: parent.right; top: problemLabel.bottom; bottom: parent.bottom }
        input: input
        acceptable: sheet.acceptable
        onAccepted: sheet.accept()
    }
}
