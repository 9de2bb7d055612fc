// SPDX-License-Identifier: Apache-2.0
// A push button: primary (the next step), normal, quiet (no frame) or chosen by color. A text that is wider than the button gets smaller.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: button

    enum Kind { Normal, Primary, Quiet }

    property int kind: Button.Normal
    property string glyph
    property string note               // second, smaller line
    property int textSize: primary ? Theme.size.title : Theme.size.body

    readonly property bool primary: kind === Button.Primary && !locked
    readonly property color inkColor: !enabled ? Theme.color.disabledInk : locked ? Theme.color.secondaryInk : primary ? Theme.color.touchInk : Theme.color.touch

    readonly property real signRoom: glyph.length === 0 ? 0 : sign.width + (text.length > 0 ? Theme.size.spacing : 0)
    readonly property real textRoom: width - 2 * Theme.size.accent - signRoom

    implicitWidth: Math.max(Theme.size.touch, signRoom + (text.length === 0 ? 0 : Math.max(title.implicitWidth, note.length > 0 ? remark.implicitWidth : 0)) + 2 * Theme.size.padding)
    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: !button.enabled ? (button.kind === Button.Quiet ? "transparent" : Theme.color.inset)
            : button.primary ? (button.down ? Theme.color.touchPressed : Theme.color.touch)
            : button.down ? Theme.color.touchTint
            : button.kind === Button.Quiet ? "transparent" : Theme.color.inset
        border { width: button.kind === Button.Normal || button.kind === Button.Primary && button.locked || !button.enabled && button.primary ? Theme.size.hairline : 0; color: Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Row {
            anchors.centerIn: parent
            spacing: Theme.size.spacing
            IconLabel {
                id: sign
                anchors.verticalCenter: parent.verticalCenter
                visible: button.glyph.length > 0
                code: button.glyph
                color: button.inkColor
            }
            Column {
                anchors.verticalCenter: parent.verticalCenter
                visible: button.text.length > 0
                Label {
                    id: title
                    anchors.horizontalCenter: parent.horizontalCenter
                    width: Math.min(implicitWidth, button.textRoom)
                    fontSizeMode: Text.HorizontalFit
                    text: button.text
                    color: button.inkColor
                    font { pixelSize: button.textSize; weight: Font.DemiBold }
                }
                Label {
                    id: remark
                    anchors.horizontalCenter: parent.horizontalCenter
                    width: Math.min(implicitWidth, button.textRoom)
                    fontSizeMode: Text.HorizontalFit
                    visible: button.note.length > 0
                    text: button.note
                    color: button.inkColor
                    font.pixelSize: Theme.size.caption
                }
            }
        }
    }
}
