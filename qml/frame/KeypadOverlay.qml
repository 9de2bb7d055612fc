// SPDX-License-Identifier: Apache-2.0
// The keypad over the page: beside Stop, or over the sheet that stands beside the page.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls

Overlay {
    id: overlay

    required property var fields           // list of Value
    required property int index
    required property string heading       // instead of the label of a field; empty: the label
    required property real leftEdge        // of what stands beside the page
    required property real rightEdge
    // So much for the keypad, the rest for the curve beside it. It covers the keys of the sheet below wholly.
    readonly property real besideWidth: Math.max(keypad.minWidth, overlay.rightEdge - overlay.leftEdge, Math.min(keypad.implicitWidth, 0.67 * width - leftEdge))

    besideRight: beside ? keypad.x + keypad.width : 0
    free: beside ? width : keypad.x
    pending: keypad.pending
    ready: keypad.ready
    onTaken: keypad.take()

    FieldKeypad {
        id: keypad
        x: overlay.beside ? overlay.leftEdge : overlay.width - width
        width: overlay.beside ? overlay.besideWidth : implicitWidth
        height: overlay.height
        fields: overlay.fields
        index: overlay.index
        heading: overlay.heading
        warning: overlay.warning
        onEdited: overlay.warned = false
        onClosed: overlay.closed()
    }
}
