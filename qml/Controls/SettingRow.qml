// SPDX-License-Identifier: Apache-2.0
// A row that shows a setting and opens its choices when tapped.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

T.AbstractButton {
    id: row

    required property string label
    required property string value
    property string glyph: Theme.icon.next

    implicitWidth: Theme.size.touch
    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Label {
            id: caption
            anchors { left: parent.left; leftMargin: Theme.size.padding; top: parent.top; bottom: parent.verticalCenter; topMargin: Theme.size.spacing }
            width: parent.width - 2 * Theme.size.padding
            text: row.label
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            anchors { left: caption.left; right: arrow.left; top: parent.verticalCenter; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
            text: row.value
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.caption
            font { pixelSize: Theme.size.title; weight: Font.DemiBold }
        }
        IconLabel {
            id: arrow
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            code: row.glyph
            color: Theme.color.touch
        }
    }
}
