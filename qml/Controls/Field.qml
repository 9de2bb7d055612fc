// SPDX-License-Identifier: Apache-2.0
// A number that can be tapped: label, value, unit, and a mark for pinned or derived values.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: field
    Accessible.name: field.label
    detail: field.unit.length > 0 ? field.value + " " + field.unit : field.value

    required property string label
    required property string value
    property string unit
    property bool pinned
    property bool derived
    property alias digits: readout.pixelSize
    property bool compact: true            // in a narrow tile; otherwise the number is at the right
    signal explain()

    implicitWidth: Theme.size.touch
    implicitHeight: Theme.size.touch
    onPressAndHold: field.explain()

    readonly property real lockRoom: locked ? Math.max(0, Theme.size.caption + 2 * Theme.size.accent - inset) : 0
    readonly property int inset: compact ? Theme.size.spacing + Theme.size.outline : Theme.size.padding

    background: Rectangle {
        radius: Theme.size.radius
        color: field.pinned || field.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: field.pinned ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Readout {
            id: readout
            anchors { fill: parent; leftMargin: field.inset; rightMargin: field.inset; topMargin: field.inset - Theme.size.outline; bottomMargin: Theme.size.accent }
            Accessible.ignored: true       // the field says it
            title: field.label
            titleInset: field.lockRoom + (mark.visible ? mark.width : 0)
            text: field.value
            unit: field.unit
            pixelSize: Theme.size.value
            smallest: Theme.size.smallestText
            atRight: !field.compact
            ink: field.derived || field.locked ? Theme.color.secondaryInk : Theme.color.ink
        }
        IconLabel {
            id: mark
            x: parent.width - width - field.inset - field.lockRoom
            y: field.inset - Theme.size.outline
            visible: field.pinned || field.derived
            code: field.pinned ? Theme.icon.pin : Theme.icon.derived
            color: field.pinned ? Theme.color.touch : Theme.color.secondaryInk
            font.pixelSize: Theme.size.title
        }
    }
}
