// SPDX-License-Identifier: Apache-2.0
// Start and Stop, on every page and beside every dialog, with a key between them for the necessary first step: reset, home.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: column

    property bool covered                  // during cleaning and a question about the screen; nothing may start
    signal startRefused()

    readonly property bool homes: Maintenance.homing.offered
    readonly property bool between: Controller.faulted || homes

    implicitWidth: Theme.size.commandKey

    CommandKey {
        objectName: "startKey"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: stopKey.top; bottomMargin: column.between ? 2 * Theme.size.gap + Theme.size.commandKey : Theme.size.gap }
        glyph: Theme.icon.start
        text: qsTr("Start")
        ready: Controller.canStart && !column.covered
        note: Controller.connection !== Controller.Connection.Connected ? qsTr("no connection")
            : holdMs === 0 ? "" : tooShort ? qsTr("hold longer") : qsTr("hold")
        holdMs: ready && Settings.startIsHeld ? 500 : 0
        onHeld: Controller.start()
        onClicked: {
            if (ready && holdMs === 0)
                Controller.start()
            else if (!ready && !acted && !column.covered)
                column.startRefused()
        }
    }
    Repeater {
        model: column.between ? 1 : 0
        CommandKey {
            objectName: "middleKey"
            anchors { left: column.left; right: column.right; bottom: stopKey.top; bottomMargin: Theme.size.gap }
            enabled: !column.covered
            small: true
            glyph: column.homes ? Theme.icon.home : Theme.icon.resetFault
            text: column.homes ? Maintenance.homing.keyText : qsTr("Reset")
            baseColor: column.homes ? Theme.color.touch : Theme.color.fault
            onClicked: column.homes ? Maintenance.homing.home() : Controller.resetFault()
        }
    }
    CommandKey {
        id: stopKey
        objectName: "stopKey"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        // Half of the column, unless the keys above need more.
        height: Math.max(Theme.size.commandKey, Math.min((parent.height - Theme.size.gap) / 2,
            parent.height - (column.between ? 2 : 1) * (Theme.size.commandKey + Theme.size.gap)))
        glyph: Theme.icon.stop
        square: true
        filled: true
        text: qsTr("Stop")
        note: Controller.stopWaits ? qsTr("not sent yet") : Controller.state === Controller.State.Stopping ? qsTr("again: immediate") : ""
        baseColor: Theme.color.stop
        pressedColor: Theme.color.stopPressed
        onPressed: Controller.stop()
    }
}
