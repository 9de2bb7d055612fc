// SPDX-License-Identifier: Apache-2.0
// The level of the person at the panel, which the frame sets, and the tap that is being handled. A tap that asks for a login
// is carried out after it.
pragma ComponentBehavior: Bound
pragma Singleton
import QtQuick

QtObject {
    id: permission

    signal loginWanted(int level)          // by a locked key that does nothing else

    property int level: 3
    property list<string> words            // what a control needs, from the first level on
    property Item tapped: null             // the control, and what its tap does
    property var action: null

    readonly property Timer handled: Timer {
        interval: 0
        onTriggered: permission.forget()
    }

    function tap(control: Item, action: var): void {
        permission.tapped = control
        permission.action = action
        permission.handled.restart()
    }
    function forget(): void {
        permission.tapped = null
        permission.action = null
    }
    function needs(level: int): string {
        return level > permission.level ? permission.words[level - 1] ?? "" : ""
    }
}
