// SPDX-License-Identifier: Apache-2.0
// One frame of the line: time, direction, contents.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: row

    required property string time
    required property bool sent
    required property string words
    required property bool error
    property bool shaded

    implicitHeight: Math.round(Theme.size.body * 1.9)
    color: shaded ? Theme.color.inset : Theme.color.surface

    Label {
        id: clock
        x: Theme.size.spacing
        width: Theme.size.caption * 7
        height: parent.height
        text: row.time
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    IconLabel {
        id: way
        anchors { left: clock.right; verticalCenter: parent.verticalCenter }
        code: row.error ? Theme.icon.alert : row.sent ? Theme.icon.sent : Theme.icon.received
        color: row.error ? Theme.color.fault : row.sent ? Theme.color.touch : Theme.color.secondaryInk
        font.pixelSize: Theme.size.title
    }
    Label {
        anchors { left: way.right; leftMargin: Theme.size.spacing; right: parent.right; rightMargin: Theme.size.padding }
        height: parent.height
        text: row.words
        fontSizeMode: Text.HorizontalFit
        color: row.error ? Theme.color.fault : Theme.color.ink
    }
}
