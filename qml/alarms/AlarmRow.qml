// SPDX-License-Identifier: Apache-2.0
// One occurrence of an alarm: severity, title, state, time, count. Alarms that need to be acknowledged stand out.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

TouchButton {
    id: row
    Accessible.name: row.title

    required property string code
    required property string title
    required property int severity
    required property string time
    required property string clockNote
    required property string stateText
    required property bool calls
    required property bool live
    required property int times

    readonly property color severityColor: severity === Alarms.Severity.Fault ? Theme.color.fault
        : severity === Alarms.Severity.Warning ? Theme.color.warning : Theme.color.touch

    implicitHeight: Theme.size.touch
    background: Rectangle {
        color: row.down ? Theme.color.touchTint : Theme.color.surface
        Rectangle {
            anchors.bottom: parent.bottom
            width: parent.width
            height: Theme.size.hairline
            color: Theme.color.line
        }
        Rectangle {
            visible: row.calls
            width: Theme.size.accent
            height: parent.height
            color: row.severityColor
        }
    }
    Item {
        anchors.fill: parent
        IconLabel {
            id: mark
            anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            code: row.severity === Alarms.Severity.Fault ? Theme.icon.fault
                : row.severity === Alarms.Severity.Warning ? Theme.icon.alert : Theme.icon.information
            color: row.live || row.calls ? row.severityColor : Theme.color.secondaryInk
        }
        Column {
            anchors { left: mark.right; leftMargin: Theme.size.padding; right: when.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            Label {
                objectName: "alarmTitle"
                width: parent.width
                text: row.title
                fontSizeMode: Text.HorizontalFit
                font.weight: row.calls ? Font.Bold : Font.Normal
            }
            Label {
                objectName: "alarmState"
                width: parent.width
                text: Theme.fill(qsTr("%1 · %2"), [row.code, row.stateText])
                fontSizeMode: Text.HorizontalFit
                color: row.calls ? row.severityColor : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Column {
            id: when
            anchors { right: parent.right; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            Label {
                anchors.right: parent.right
                text: row.time
                font.pixelSize: Theme.size.caption
            }
            Label {
                objectName: "alarmClock"
                anchors.right: parent.right
                visible: text.length > 0
                text: row.clockNote
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                anchors.right: parent.right
                visible: row.times > 1 && row.clockNote.length === 0
                text: qsTr("%1 times").arg(Theme.count(row.times, 0))
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
