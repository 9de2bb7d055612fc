// SPDX-License-Identifier: Apache-2.0
// A number that can be tapped: label, value, unit, and a mark for pinned or derived values.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: field
    Accessible.name: field.label
    Accessible.description: field.unit.length > 0 ? field.value + " " + field.unit : field.value

    required property string label
    required property string value
    property string unit
    property bool pinned
    property bool derived
    property bool compact: true            // unit below the value; otherwise beside it
    signal explain()

    implicitWidth: Theme.size.touch
    implicitHeight: Theme.size.touch
    onPressAndHold: field.explain()

    readonly property bool below: compact && caption.lineCount < 2    // a long label takes the space of the unit
    // The mark remains when the unit is beside the value.
    readonly property real markRoom: compact && !below && mark.visible ? mark.width + Theme.size.accent : 0
    readonly property int inset: compact ? Theme.size.spacing + Theme.size.outline : Theme.size.padding

    background: Rectangle {
        radius: Theme.size.radius
        color: field.pinned || field.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: field.pinned ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Label {
            id: caption
            x: field.inset
            y: field.inset - Theme.size.outline
            width: parent.width - 2 * field.inset - (mark.visible && !field.compact ? mark.width : 0)
            text: field.label
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
            // Two lines before the text becomes too small to read. The small letters are measured themselves, because whole
            // pixels make them wider than their share of the large ones.
            wrapMode: smallest.advanceWidth > width ? Text.WordWrap : Text.NoWrap
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: smallest.font.pixelSize
            lineHeight: lineCount > 1 ? 0.85 : 1
            TextMetrics {
                id: smallest
                font.pixelSize: Theme.size.caption - 2
                text: field.label
            }
        }
        Label {
            id: number
            x: field.inset
            width: parent.width - 2 * field.inset - (field.below ? 0 : suffix.width + Theme.size.spacing + field.markRoom)
            anchors.top: caption.bottom
            anchors.bottom: field.below ? suffix.top : parent.bottom
            anchors.topMargin: field.below ? 0 : -Theme.size.accent
            anchors.bottomMargin: field.below ? 0 : Theme.size.accent
            text: field.value
            color: field.derived ? Theme.color.secondaryInk : Theme.color.ink
            fontSizeMode: Text.Fit
            minimumPixelSize: Theme.size.caption - (field.markRoom > 0 ? 2 : 0)
            horizontalAlignment: field.compact ? Text.AlignLeft : Text.AlignRight
            font { pixelSize: Theme.size.value; bold: true }
        }
        Label {
            id: suffix
            x: field.below ? field.inset : parent.width - width - field.inset - field.markRoom
            y: field.below ? parent.height - height - field.inset + Theme.size.outline
                : number.y + number.baselineOffset - baselineOffset
            text: field.unit
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        IconLabel {
            id: mark
            x: parent.width - width - field.inset
            y: field.compact ? suffix.y + (suffix.height - height) / 2 : caption.y + (caption.height - height) / 2
            visible: field.pinned || field.derived
            code: field.pinned ? Theme.icon.pin : Theme.icon.derived
            color: field.pinned ? Theme.color.touch : Theme.color.secondaryInk
            font.pixelSize: Theme.size.title
        }
    }
}
