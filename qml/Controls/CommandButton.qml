// SPDX-License-Identifier: Apache-2.0
// The base of the keys that command the machine. Such a key acts once a finger has held it for `holdMs`, under a ring that
// fills; a release or a finger that leaves the key before cancels. Locked, a tap asks for the login, and the key is held again after it.
// No keyboard reaches it, and a scanner is a keyboard.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: key

    property int holdMs: Theme.holdTime    // 0: a tap acts
    property bool ready: true              // false: a tap says only why
    property bool acted: true              // the touch has acted or ended
    property Item ringHost: key            // has the ring in its center
    property color ringColor: Theme.color.touch
    readonly property bool holds: holdMs > 0 && !locked
    readonly property bool holding: ready && holds && pressed && !acted
    readonly property string holdNote: !holds ? "" : hint.running ? qsTr("hold longer") : qsTr("hold")

    signal commanded()
    signal refused()

    focusPolicy: Qt.NoFocus
    waitsForLogin: false                   // the machine never moves because somebody logged in
    onPressed: acted = false
    // A finger that slides back onto the key begins nothing: that needs a new touch.
    onPressedChanged: {
        if (pressed || !ready || !holds)
            return
        if (!acted)
            hint.restart()
        acted = true
    }
    // The touch ends when the key is no longer ready.
    onReadyChanged: {
        if (!ready && pressed)
            acted = true
    }
    onClicked: {
        if (!ready && !acted)
            refused()
        else if (ready && locked)
            Permission.loginWanted(level)
        else if (ready && !holds)
            commanded()
    }

    Timer {
        interval: key.holdMs
        running: key.holding
        onTriggered: {
            key.acted = true
            key.commanded()
        }
    }
    Timer {
        id: hint
        interval: 2000
    }
    Repeater {
        parent: key.ringHost
        model: key.holding ? 1 : 0
        HoldRing {
            anchors.centerIn: parent
            width: Theme.size.largeIcon + 2 * Theme.size.spacing
            height: width
            time: key.holdMs
            color: key.ringColor
        }
    }
}
