// SPDX-License-Identifier: Apache-2.0
// Slanting lines over an area: what is drawn there does not count.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: hatch

    required property color color
    readonly property real step: Theme.size.padding // spacing is less with gloves, and the text below it would drown

    clip: true

    Repeater {
        model: Math.max(0, Math.ceil((hatch.width + hatch.height) / hatch.step))
        Rectangle {
            required property int index
            x: index * hatch.step - hatch.height
            y: hatch.height - height
            width: Theme.size.hairline
            height: hatch.height * Math.SQRT2
            transformOrigin: Item.Bottom
            rotation: 45
            antialiasing: true
            color: hatch.color
        }
    }
}
