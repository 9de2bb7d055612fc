// SPDX-License-Identifier: Apache-2.0
// Which sentence the operator must see now: a Stop that waits, the answer to a command, an active alarm, a lost link. Alarms can be put
// aside and stay on the Alarms page, where acknowledging them puts them aside too; a waiting Stop is withdrawn or sent.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Machine

Item {
    id: host

    property string refusal                // why Start was refused; set by the frame
    property string putAside

    // A link takes a moment to come up; only one that stays away is worth a banner.
    readonly property bool isComing: Machine.connection === Machine.Connection.Searching
        || Machine.connection === Machine.Connection.Connecting
    readonly property bool isTrouble: isComing ? patience.over : Machine.connection !== Machine.Connection.Connected
    readonly property string linkTrouble: isTrouble ? Machine.connectionText : ""
    readonly property string alarm: Machine.alarmText.length > 0 ? Machine.alarmText : linkTrouble
    readonly property string answer: Machine.commandMessage.length > 0 ? Machine.commandMessage
        : Settings.notice.length > 0 ? Settings.notice : Editor.notice.length > 0 ? Editor.notice
        : Records.notice.length > 0 ? Records.notice : refusal
    readonly property bool stopShown: Machine.stopWaits
    readonly property bool alarmShown: !stopShown && answer.length === 0 && alarm.length > 0 && alarm !== putAside && !Alarms.seen
    readonly property bool shown: stopShown || answer.length > 0 || alarmShown

    function accept() {
        if (host.stopShown) {
            Machine.withdrawStop()
            return
        }
        if (host.alarmShown)
            host.putAside = host.alarm
        host.refusal = ""
        Machine.dismissMessage()
        Settings.dismissNotice()
        Editor.dismissNotice()
        Records.dismissNotice()
    }

    implicitHeight: Theme.size.actionBar
    visible: shown

    Timer {
        id: patience

        property bool over

        interval: 3000
        running: host.isComing && !over
        onTriggered: over = true
    }

    Connections {
        target: Machine
        function onConnectionChanged() {
            if (Machine.connection === Machine.Connection.Connected)
                patience.over = false
        }
    }

    Banner {
        objectName: "banner"
        anchors.fill: parent
        text: host.stopShown ? Machine.stopWaitsText : host.alarmShown ? host.alarm : host.answer
        severity: host.stopShown ? Banner.Warning : host.alarmShown ? (Machine.faulted ? Banner.Fault : Banner.Warning) : Banner.Information
        buttonText: host.stopShown ? qsTr("Withdraw") : qsTr("OK")
        onAccepted: host.accept()
    }
}
