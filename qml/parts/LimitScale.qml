// SPDX-License-Identifier: Apache-2.0
// A number as a bar that begins at 0: how far it is from its limit, a stroke; and what is set, a
// blue mark. A value beyond the limit is red.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: scale

    required property real value           // NaN: unknown
    required property real end             // of the scale, more than 0
    property real limit: NaN               // NaN: none
    property real set: NaN                 // NaN: none
    property bool stale
    property int thickness: Theme.size.spacing
    property color fill: scale.beyond ? Theme.color.fault : Theme.color.target
    property color setColor: Theme.color.touch
    readonly property bool beyond: value > limit

    function place(value: real): real { return Math.round(width * Math.min(1, Math.max(0, value / scale.end))) }

    implicitHeight: bar.height + 2 * Theme.size.accent

    Rectangle {
        id: bar
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        height: scale.thickness
        radius: height / 2
        color: Theme.color.line
        Rectangle {
            visible: scale.value > 0
            width: Math.max(height, scale.place(scale.value))
            height: parent.height
            radius: height / 2
            color: scale.stale ? Theme.color.disabledInk : scale.fill
        }
    }
    Rectangle {
        visible: !isNaN(scale.limit)
        x: scale.place(scale.limit) - width
        width: Theme.size.outline
        height: parent.height
        color: Theme.color.ink
    }
    Rectangle {
        visible: !isNaN(scale.set)
        x: scale.place(scale.set) - width / 2
        width: Theme.size.accent
        height: parent.height
        radius: width / 2
        color: scale.setColor
    }
}
