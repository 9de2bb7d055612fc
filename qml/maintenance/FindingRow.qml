// SPDX-License-Identifier: Apache-2.0
// One finding of the link doctor: place, problem, action.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: row

    required property string title
    required property string note
    required property string detail
    required property bool usable

    implicitHeight: words.height + 2 * Theme.size.spacing
    radius: Theme.size.radius
    color: Theme.color.inset
    border { width: Theme.size.hairline; color: row.usable ? Theme.color.good : Theme.color.line }

    IconLabel {
        id: mark
        anchors { left: parent.left; leftMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.spacing }
        code: row.usable ? Theme.icon.check : Theme.icon.alert
        color: row.usable ? Theme.color.good : Theme.color.warning
    }
    Column {
        id: words
        anchors { left: mark.right; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.spacing }
        spacing: Theme.size.outline
        Label {
            width: parent.width
            wrapMode: Text.WordWrap
            text: row.title
            font.weight: Font.DemiBold
        }
        Label {
            width: parent.width
            text: row.note
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            width: parent.width
            wrapMode: Text.WordWrap
            text: row.detail
            font.pixelSize: Theme.size.caption
        }
    }
}
