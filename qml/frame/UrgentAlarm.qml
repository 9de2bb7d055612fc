// SPDX-License-Identifier: Apache-2.0
// The most urgent active alarm, depending on the space: icon and title, icon and id, or the icon alone.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: view

    readonly property real room: width - mark.width - Theme.size.accent
    readonly property color ink: Alarms.urgentSeverity === Alarms.Severity.Fault ? Theme.color.fault : Theme.color.warning

    visible: Alarms.urgentCode.length > 0 && width >= mark.width

    TextMetrics {
        id: title
        font: words.font
        text: Alarms.urgentTitle
    }
    TextMetrics {
        id: code
        font: words.font
        text: Alarms.urgentCode
    }
    Row {
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        spacing: Theme.size.accent
        IconLabel {
            id: mark
            anchors.verticalCenter: parent.verticalCenter
            code: Theme.icon.alarm
            color: view.ink
            font.pixelSize: Theme.size.title
        }
        Label {
            id: words
            objectName: "urgentAlarm"
            anchors.verticalCenter: parent.verticalCenter
            visible: text.length > 0
            text: title.advanceWidth < view.room ? title.text : code.advanceWidth < view.room ? code.text : ""
            color: view.ink
            font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
        }
    }
}
