// SPDX-License-Identifier: Apache-2.0
// One page in the navigation. The current page has a tint and an accent at its edge; a page that needs attention has a
// number.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: button

    required property string glyph
    property int calls                     // number displayed; 0: none
    property color callColor: Theme.color.fault
    readonly property color inkColor: checked || down ? Theme.color.touch : calls > 0 ? callColor : Theme.color.secondaryInk

    background: Rectangle {
        color: button.checked || button.down ? Theme.color.touchTint : "transparent"
        Rectangle {
            visible: button.checked
            width: Theme.size.accent
            height: parent.height
            color: Theme.color.touch
        }
    }
    Item {
        anchors.fill: parent
        Repeater {
            model: button.calls > 0 ? 1 : 0
            Rectangle {
                x: keys.x + mark.x + mark.width
                y: keys.y
                width: Math.max(height, number.implicitWidth + 2 * Theme.size.accent)
                height: number.implicitHeight
                radius: height / 2
                color: button.callColor
                Label {
                    id: number
                    objectName: "navCalls"
                    anchors.centerIn: parent
                    text: button.calls > 99 ? "99+" : button.calls
                    color: Theme.color.touchInk
                    font { pixelSize: 0.85 * Theme.size.caption; bold: true }
                }
            }
        }
        Column {
            id: keys
            anchors.centerIn: parent
            spacing: Theme.size.accent
            IconLabel {
                id: mark
                anchors.horizontalCenter: parent.horizontalCenter
                code: button.glyph
                color: button.inkColor
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                width: Math.min(implicitWidth, button.width - 3 * Theme.size.accent)   // clear of the mark at the edge
                fontSizeMode: Text.HorizontalFit
                text: button.text
                color: button.inkColor
                font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
            }
        }
    }
}
