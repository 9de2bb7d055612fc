// SPDX-License-Identifier: Apache-2.0
// The login above any open dialog, and the longer PIN that may follow it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

Loader {
    id: host

    property int userOfShortPin            // user who must choose a longer PIN

    property Item refused: null            // what was tapped, and what that does after the login
    property var action: null

    active: false

    function open(level: int): void {
        if (host.active)
            return
        host.refused = Permission.tapped
        host.action = Permission.action
        host.setSource("../Access/LoginSheet.qml", { level: level })
        host.active = true
    }
    function carryOut(): void {
        const refused = host.refused
        const action = host.action
        host.active = false
        if (refused?.visible && refused.enabled)
            action()
    }
    // Replaces the login.
    function openShortPin(user: int): void {
        host.userOfShortPin = user
        host.setSource("../Access/NewPinSheet.qml", { title: qsTr("Your PIN is too short"), level: Access.Service })
        host.active = true
    }

    onActiveChanged: {
        if (!host.active)
            host.refused = null
    }

    Connections {
        target: host.item
        ignoreUnknownSignals: true
        function onClosed() { host.active = false }
        function onEntered(pin: string) { Access.changePin(host.userOfShortPin, pin) }
    }
    Connections {
        target: Permission
        function onLoginWanted(level: int) { Access.ask(level) }
    }
    Connections {
        target: Access
        function onNewPinWanted(user: int) { host.openShortPin(user) }
        function onLoginRequested(level: int) { host.open(level) }
        function onLoginSucceeded() { host.carryOut() }
    }
}
