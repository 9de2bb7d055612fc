// SPDX-License-Identifier: Apache-2.0
// One occurrence of an alarm: severity, title, state, time, count. Alarms that need to be acknowledged stand out.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

ListRow {
    id: row

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

    glyph: severity === Alarms.Severity.Fault ? Theme.icon.fault : severity === Alarms.Severity.Warning ? Theme.icon.alert : Theme.icon.information
    sign.color: live || calls ? severityColor : Theme.color.secondaryInk
    text: title
    note: Theme.fill(qsTr("%1 · %2"), [code, stateText])
    noteLabel.objectName: "alarmState"
    noteLabel.color: calls ? severityColor : Theme.color.secondaryInk
    rightText: time
    rightNote: clockNote.length > 0 ? clockNote : times > 1 ? qsTr("%1 times").arg(Theme.count(times, 0)) : ""
    rightNoteLabel.objectName: "alarmClock"

    Rectangle {
        visible: row.calls
        width: Theme.size.accent
        height: parent.height
        radius: Theme.size.outline
        color: row.severityColor
    }
}
