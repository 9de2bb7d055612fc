// SPDX-License-Identifier: Apache-2.0
// The keypad over the page: beside Stop, or over the sheet that stands beside the page; a touch elsewhere cancels.
pragma ComponentBehavior: Bound
import QtQuick

Overlay {
    id: overlay

    required property var fields           // list of EditorField
    required property int index
    required property Item field
    required property bool beside          // the sheet of the field leaves the page visible, and so does the keypad

    besideRight: beside ? keypad.width : 0
    free: beside ? width : keypad.x

    MouseArea {
        anchors.fill: parent
        onClicked: overlay.closed()
    }
    FieldKeypad {
        id: keypad
        x: overlay.beside ? 0 : overlay.width - width
        height: overlay.height
        fields: overlay.fields
        index: overlay.index
        onClosed: overlay.closed()
    }
}
