// SPDX-License-Identifier: Apache-2.0
// The keypad over the page: a frame around the field, the keypad beside Stop; a touch elsewhere cancels.
pragma ComponentBehavior: Bound
import QtQuick

Overlay {
    id: overlay

    required property var fields           // list of EditorField
    required property int index
    required property Item field

    free: width - keypad.width

    MouseArea {
        anchors.fill: parent
        onClicked: overlay.closed()
    }
    FieldKeypad {
        id: keypad
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
        fields: overlay.fields
        index: overlay.index
        onClosed: overlay.closed()
    }
}
