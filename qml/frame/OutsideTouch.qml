// SPDX-License-Identifier: Apache-2.0
// Handles Escape and a touch outside of the topmost sheet, keypad or login: nothing that was typed is lost. The rule is in qml/README.md.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

TouchGate {
    id: outside

    required property Overlay login
    required property Overlay keypad
    required property Overlay sheet
    required property Item navigation
    readonly property Overlay topmost: login ?? keypad ?? sheet
    readonly property bool pending: (login?.pending ?? false) || (keypad?.pending ?? false) || (sheet?.pending ?? false)
    property Overlay takenKeypad           // the present touch has taken its number; it stays in place until the touch has acted

    visible: topmost !== null

    // Takes a valid number. Returns false when something that was typed stays.
    function settle(): bool {
        return (outside.login?.settle() ?? true) && (outside.keypad?.settle() ?? true) && (outside.sheet?.settle() ?? true)
    }
    // Closes the topmost layer, or warns.
    function leave(): void {
        outside.topmost.warned = outside.topmost.pending
        if (!outside.topmost.pending)
            outside.topmost.closed()
    }
    // Returns true when a control outside of the topmost layer may act; takes a valid number before.
    function opensWayTo(control: Item): bool {
        if (outside.isIn(control, outside.navigation))
            return outside.settle()
        const isReached = !outside.login && (!outside.sheet || outside.sheet.beside || outside.keypad && outside.isIn(control, outside.sheet))
        return isReached && (outside.keypad?.settle() ?? true)
    }

    onTouched: (target, isControl) => {
        const layer = outside.topmost
        if (outside.isIn(target, layer) || layer === outside.sheet && layer.beside)
            return
        if (isControl && outside.opensWayTo(target)) {
            outside.takenKeypad = outside.keypad
            return
        }
        outside.refuse()
        if (outside.topmost === layer) // else to confirm it needs a login, which has opened
            outside.leave()
    }
    onLifted: {
        if (outside.takenKeypad && outside.takenKeypad === outside.keypad)
            outside.keypad.closed()
        outside.takenKeypad = null
    }

    Shortcut {
        sequence: "Escape"
        enabled: outside.visible && !Display.dark
        onActivated: outside.leave()
    }
}
