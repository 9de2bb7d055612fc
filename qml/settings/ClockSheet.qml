// SPDX-License-Identifier: Apache-2.0
// The clock of this computer: a time server, the time zone, and keys that move the clock when no server sets it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    title: qsTr("Clock")
    note: SystemClock.stateText
    Component.onCompleted: SystemClock.watched = true
    Component.onDestruction: SystemClock.watched = false

    component Step: Button {
        required property int minutes
        level: Access.Service
        width: (keys.width - keys.spacing) / 2
        enabled: SystemClock.movable
        onClicked: SystemClock.move(minutes)
    }

    NetworkInfo { id: facts }
    Column {
        anchors { left: parent.left; top: parent.top }
        width: Math.round(parent.width * 0.5)
        spacing: Theme.size.spacing
        Label {
            objectName: "clockNow"
            width: parent.width
            wrapMode: Text.WordWrap
            text: facts.clockText
            font.weight: Font.DemiBold
        }
        Label {
            width: parent.width
            text: qsTr("Time server")
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Segmented {
            objectName: "clockServer"
            level: Access.Service
            width: parent.width
            enabled: SystemClock.canUseTimeServer && !SystemClock.busy
            choices: [{ key: false, text: qsTr("Off"), name: "clockServerOff" }, { key: true, text: qsTr("On"), name: "clockServerOn" }]
            current: SystemClock.available ? SystemClock.usesTimeServer : null
            onChosen: key => {
                if (Access.ask(Access.Service))
                    SystemClock.setUsesTimeServer(key)
            }
        }
        SettingRow {
            objectName: "clockZone"
            width: parent.width
            enabled: SystemClock.available && !SystemClock.busy
            label: qsTr("Time zone")
            value: SystemClock.available ? SystemClock.zone : "--"
            onClicked: Frame.open("Settings/ZonePicker", {})
        }
        Label {
            objectName: "clockProblem"
            width: parent.width
            visible: text.length > 0
            wrapMode: Text.WordWrap
            text: SystemClock.problem
            color: Theme.color.fault
            font.pixelSize: Theme.size.caption
        }
    }
    Grid {
        id: keys
        anchors { right: parent.right; top: parent.top }
        width: Math.round(parent.width * 0.5) - Theme.size.padding
        columns: 2
        spacing: Theme.size.spacing
        Step {
            objectName: "clockEarlierDay"
            minutes: -1440
            text: qsTr("− 1 d")
        }
        Step {
            objectName: "clockLaterDay"
            minutes: 1440
            text: qsTr("+ 1 d")
        }
        Step {
            objectName: "clockEarlierHour"
            minutes: -60
            text: qsTr("− 1 h")
        }
        Step {
            objectName: "clockLaterHour"
            minutes: 60
            text: qsTr("+ 1 h")
        }
        Step {
            objectName: "clockEarlierTen"
            minutes: -10
            text: qsTr("− 10 min")
        }
        Step {
            objectName: "clockLaterTen"
            minutes: 10
            text: qsTr("+ 10 min")
        }
        Step {
            objectName: "clockEarlier"
            minutes: -1
            text: qsTr("− 1 min")
        }
        Step {
            objectName: "clockLater"
            minutes: 1
            text: qsTr("+ 1 min")
        }
    }
}
