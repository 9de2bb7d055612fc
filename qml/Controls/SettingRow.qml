// SPDX-License-Identifier: Apache-2.0
// A row that shows a setting and opens its choices when tapped.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: row
    Accessible.name: row.label
    detail: row.value

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
        Column {
            anchors { left: parent.left; leftMargin: Theme.size.padding; right: arrow.left; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.outline
            Label {
                width: parent.width
                text: row.label
                fontSizeMode: Text.HorizontalFit
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                readonly property bool tooLong: smallest.advanceWidth > width
                width: parent.width
                text: row.value
                fontSizeMode: Text.HorizontalFit
                wrapMode: tooLong ? Text.WordWrap : Text.NoWrap
                maximumLineCount: 2
                color: row.locked ? Theme.color.secondaryInk : Theme.color.ink
                lineHeight: lineCount > 1 ? 0.85 : 1
                font { pixelSize: tooLong ? Theme.size.caption : Theme.size.title; weight: Font.DemiBold }
                TextMetrics {
                    id: smallest
                    font { pixelSize: Theme.size.smallestText; weight: Font.DemiBold }
                    text: row.value
                }
            }
        }
        IconLabel {
            id: arrow
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            code: row.glyph
            color: row.locked ? Theme.color.secondaryInk : Theme.color.touch
        }
    }
}
