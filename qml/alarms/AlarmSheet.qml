// SPDX-License-Identifier: Apache-2.0
// One occurrence of an alarm: cause, action, time and count, with keys to acknowledge and to shelve it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property AlarmDetail alarm: Alarms.detail

    function shelve(hours: int): void {
        if (!Access.ask(Access.Technician))
            return
        Alarms.shelveShown(hours)
        sheet.closed()
    }

    title: Theme.fill(qsTr("%1 · %2"), [alarm.code, alarm.title])
    note: Theme.fill(qsTr("%1 · %2"), [alarm.severityText, alarm.stateText])

    Flickable {
        id: view
        anchors.fill: parent
        contentHeight: body.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: body
            width: view.width - 2 * Theme.size.accent
            spacing: Theme.size.padding
            AlarmText {
                name: "alarmCause"
                caption: qsTr("Cause")
                large: true
                text: sheet.alarm.cause
            }
            AlarmText {
                name: "alarmAction"
                caption: qsTr("What to do")
                large: true
                text: sheet.alarm.action
            }
            AlarmText {
                name: "alarmDetail"
                caption: qsTr("Detail")
                text: sheet.alarm.detail
            }
            Rectangle {
                width: parent.width
                height: Theme.size.hairline
                color: Theme.color.line
            }
            Flow {
                width: parent.width
                spacing: 2 * Theme.size.padding
                Repeater {
                    model: [{ name: "alarmRaised", caption: qsTr("Raised"), text: sheet.alarm.raisedText },
                        { name: "alarmReturned", caption: qsTr("Cleared"), text: sheet.alarm.returnedText },
                        { name: "alarmAcknowledged", caption: qsTr("Acknowledged"), text: sheet.alarm.acknowledgedText },
                        { name: "alarmTimes", caption: qsTr("Count"), text: Theme.count(sheet.alarm.times, 0) }]
                    AlarmText {
                        required property var modelData
                        name: modelData.name
                        caption: modelData.caption
                        text: modelData.text
                        width: implicitWidth
                    }
                }
            }
        }
    }
    ScrollMark { view: view }
    footer: [
        CommandKey {
            objectName: "alarmReset"
            level: Access.Operator
            visible: Controller.faulted && sheet.alarm.severity === Alarms.Severity.Fault && sheet.alarm.code.startsWith("C-")
            width: 2 * Theme.size.touch
            small: true
            glyph: Theme.icon.resetFault
            text: qsTr("Reset")
            onCommanded: {
                Controller.resetFault()
                sheet.closed()
            }
        },
        Button {
            objectName: "alarmUnshelve"
            level: Access.Operator
            visible: sheet.alarm.shelved
            text: qsTr("Unshelve")
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                Alarms.unshelveShown()
                sheet.closed()
            }
        },
        Button {
            objectName: "alarmShelve1"
            level: Access.Technician
            visible: sheet.alarm.shelvable && !sheet.alarm.shelved
            text: qsTr("Shelve 1 h")
            onClicked: sheet.shelve(1)
        },
        Button {
            objectName: "alarmShelve8"
            level: Access.Technician
            visible: sheet.alarm.shelvable && !sheet.alarm.shelved
            text: qsTr("Shelve 8 h")
            onClicked: sheet.shelve(8)
        },
        Button {
            objectName: "alarmAcknowledge"
            level: Access.Operator
            visible: sheet.alarm.calls
            kind: Button.Primary
            text: qsTr("Acknowledge")
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                Alarms.acknowledgeShown()
                sheet.closed()
            }
        }
    ]
}
