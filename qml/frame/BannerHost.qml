// SPDX-License-Identifier: Apache-2.0
// The most important sentence for the operator: a waiting Stop, the answer to a command, an active alarm, a lost link.
// Alarms can be dismissed and stay on the Alarms page; acknowledging them there dismisses them too. A waiting Stop is
// withdrawn or sent, and the answer to a stop can be undone for some seconds.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: host

    property bool startRefused             // ends when Start would be accepted
    property bool above                    // over a sheet, a keypad or the first start: only answers to a touch
    property bool faultOnPage              // the page itself tells it
    property string answerBelow            // the sentence on the page when something opened above it
    property string putAside

    // A link needs some time to connect, and a bad plug has gaps; only a longer failure causes a banner, which takes room
    // from the page. The top bar shows each of them at once.
    readonly property bool isComing: Controller.connection === Controller.Connection.Searching
        || Controller.connection === Controller.Connection.Connecting
    readonly property bool isGap: Controller.connection === Controller.Connection.Lost && Controller.ageMs < patience.interval
    readonly property bool isTrouble: isComing ? patience.over : !isGap && Controller.connection !== Controller.Connection.Connected
    readonly property string linkTrouble: isTrouble ? Controller.connectionText : ""
    readonly property var alarms: Controller.alarmTexts
    readonly property string alarm: alarms.length > 0 ? alarms.join("\n") : linkTrouble
    // Every screen has space for one alarm at a time.
    readonly property string mostUrgent: alarms.length > 1 ? Theme.fill(qsTr("%1\nAnd %2 more."), [alarms[0], alarms.length - 1]) : alarm
    readonly property string answer: Controller.commandMessage.length > 0 ? Controller.commandMessage : Stops.answerText.length > 0 ? Stops.answerText : Scan.notice.length > 0 ? Scan.notice : Orders.notice.length > 0 ? Orders.notice
        : Settings.notice.length > 0 ? Settings.notice : Editor.notice.length > 0 ? Editor.notice
        : DatabaseService.notice.length > 0 ? DatabaseService.notice
        : BuilderFiles.notice.length > 0 ? BuilderFiles.notice : SoftwareUpdate.notice.length > 0 ? SoftwareUpdate.notice
        : TouchCalibration.notice.length > 0 ? TouchCalibration.notice : startRefused ? Controller.startBlockedReason : ""
    readonly property bool stopShown: Controller.stopWaits
    readonly property bool undoShown: !stopShown && answer.length > 0 && answer === Stops.answerText
    readonly property bool diskLostShown: DatabaseService.diskLost && answer.length > 0 && answer === DatabaseService.notice
    readonly property bool alarmShown: !above && !faultOnPage && !stopShown && answer.length === 0 && alarm.length > 0 && alarm !== putAside && !Alarms.seen
    readonly property bool shown: stopShown || (answer.length > 0 && !(above && answer === answerBelow)) || alarmShown

    onAboveChanged: host.answerBelow = host.above ? host.answer : ""
    onAnswerChanged: if (host.answer !== host.answerBelow) host.answerBelow = ""

    function refuseStart() {
        host.answerBelow = ""
        host.startRefused = true
    }

    // Several alarms are a list, one is its sheet.
    function showAlarms() {
        if (host.alarms.length > 1) {
            Frame.openPage("alarms")
            return
        }
        Alarms.showUrgent()
        Frame.open("Alarms/AlarmSheet", {})
    }

    function accept() {
        if (host.stopShown) {
            Controller.withdrawStop()
            return
        }
        if (host.alarmShown)
            host.putAside = host.alarm
        host.startRefused = false
        Controller.dismissMessage()
        Stops.dismissAnswer()
        Scan.dismissNotice()
        Orders.dismissNotice()
        Settings.dismissNotice()
        Editor.dismissNotice()
        DatabaseService.dismissNotice()
        BuilderFiles.dismissNotice()
        SoftwareUpdate.dismissNotice()
        TouchCalibration.dismissNotice()
    }

    Timer {
        id: patience

        property bool over

        interval: 3000
        running: host.isComing && !over
        onTriggered: over = true
    }

    Connections {
        target: Controller
        function onConnectionChanged() {
            if (Controller.connection === Controller.Connection.Connected)
                patience.over = false
        }
        function onCommandsChanged() {
            if (Controller.canStart)
                host.startRefused = false
        }
    }

    Repeater {
        model: host.shown ? 1 : 0
        Banner {
            objectName: "banner"
            anchors.fill: parent
            text: host.stopShown ? Controller.stopWaitsText : host.alarmShown ? host.mostUrgent : host.answer
            severity: host.stopShown ? Banner.Warning : host.alarmShown ? (Controller.faulted ? Banner.Fault : Banner.Warning) : host.diskLostShown ? Banner.Fault : Banner.Information
            buttonText: host.stopShown ? qsTr("Withdraw") : qsTr("OK")
            wayText: host.undoShown ? qsTr("Undo") : host.alarmShown && (host.alarms.length > 1 || Controller.faulted && Alarms.urgentCode.length > 0) ? qsTr("Show") : ""
            onAccepted: host.accept()
            wayLevel: host.undoShown ? Access.Operator : Access.Viewer
            onWayChosen: host.undoShown ? Stops.undoAnswer() : host.showAlarms()
        }
    }
}
