// SPDX-License-Identifier: Apache-2.0
// Three places on every page and beside every dialog: Start, the necessary first step (reset, reference run) or the speed of
// a run, and Stop. None ever changes its size or place.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: column

    property bool covered                  // during cleaning and a question about the screen; nothing may start
    signal startRefused()

    readonly property bool homes: Maintenance.homing.offered
    readonly property bool between: Controller.faulted || homes
    readonly property real upperHeight: (height - stopKey.height) / 2 - Theme.size.gap

    readonly property string programs: ProgramNames.active + "\n" + ProgramNames.open
    property string answered               // the programs that Start was asked about last

    // Asks once when the open recipe is not what would run.
    function start(): void {
        if (!ProgramNames.isOtherMotion || column.answered === column.programs)
            Controller.start()
        else if (Access.ask(Access.Operator))
            Frame.open("Frame/StartSheet", { onStarted: () => {
                column.answered = column.programs
                Controller.start()
            } })
    }

    implicitWidth: Theme.size.commandKey

    CommandKey {
        objectName: "startKey"
        level: Access.Operator
        anchors { left: parent.left; right: parent.right; top: parent.top }
        height: column.upperHeight
        glyph: Theme.icon.start
        text: qsTr("Start")
        ready: Controller.canStart && !column.covered
        note: Controller.connection !== Controller.Connection.Connected ? qsTr("no connection") : ready ? holdNote : ""
        holdMs: Settings.startIsHeld ? Theme.holdTime : 0
        onCommanded: column.start()
        onRefused: {
            if (!column.covered)
                column.startRefused()
        }
    }
    Repeater {
        model: column.between ? 1 : 0
        CommandKey {
            objectName: "middleKey"
            level: Access.Operator
            anchors { left: column.left; right: column.right; bottom: stopKey.top; bottomMargin: Theme.size.gap }
            height: column.upperHeight
            ready: !column.covered
            small: true
            glyph: column.homes ? Theme.icon.referenceRun : Theme.icon.resetFault
            text: column.homes ? Maintenance.homing.keyText : qsTr("Reset")
            onCommanded: column.homes ? Maintenance.homing.home() : Controller.resetFault()
        }
    }
    Repeater {
        model: !column.between && HandSpeed.offered ? 1 : 0
        CommandKey {
            objectName: "speedKey"
            level: Access.Operator
            anchors { left: column.left; right: column.right; bottom: stopKey.top; bottomMargin: Theme.size.gap }
            height: column.upperHeight
            ready: !column.covered
            small: true
            holdMs: 0
            glyph: Theme.icon.speed
            text: Theme.joined(Theme.count(HandSpeed.percent, 0), "%")
            note: qsTr("Speed")
            Accessible.name: qsTr("Speed %1").arg(text)
            onCommanded: Frame.open("Frame/SpeedSheet", {})
        }
    }
    Binding {
        target: HandSpeed
        property: "watched"
        value: column.visible && !Display.dark
    }
    CommandKey {
        id: stopKey
        objectName: "stopKey"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        // Half of the column, unless the keys above need more.
        height: Math.max(Theme.size.commandKey, Math.min((parent.height - Theme.size.gap) / 2,
            parent.height - 2 * (Theme.size.commandKey + Theme.size.gap)))
        holdMs: 0
        glyph: Theme.icon.stop
        square: true
        filled: true
        text: qsTr("Stop")
        note: Controller.stopWaits ? qsTr("not sent yet") : Controller.state === Controller.State.Stopping ? qsTr("again: immediate") : ""
        onPressed: Controller.stop()
    }
}
