// SPDX-License-Identifier: Apache-2.0
// One page in the navigation; the current page has a tint and an accent at its edge.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

T.AbstractButton {
    id: button

    required property string glyph
    property color accentColor: Theme.color.touch
    readonly property color inkColor: checked || down ? accentColor : Theme.color.secondaryInk

    background: Rectangle {
        color: button.checked || button.down ? Theme.color.touchTint : "transparent"
        Rectangle {
            visible: button.checked
            width: Theme.size.accent
            height: parent.height
            color: button.accentColor
        }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors.centerIn: parent
            spacing: Theme.size.accent
            IconLabel {
                anchors.horizontalCenter: parent.horizontalCenter
                code: button.glyph
                color: button.inkColor
            }
            Label {
                anchors.horizontalCenter: parent.horizontalCenter
                text: button.text
                color: button.inkColor
                font { pixelSize: Theme.size.caption; weight: button.checked ? Font.Bold : Font.DemiBold }
            }
        }
    }
}
