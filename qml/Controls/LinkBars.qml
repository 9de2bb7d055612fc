// SPDX-License-Identifier: Apache-2.0
// Four bars for the quality of the link, 0..4.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: bars

    required property int quality

    readonly property int barWidth: Theme.size.accent
    implicitWidth: 4 * barWidth + 3 * barWidth
    implicitHeight: Theme.size.icon * 0.75

    Repeater {
        model: 4
        Rectangle {
            required property int index
            x: index * 2 * bars.barWidth
            y: bars.height - height
            width: bars.barWidth
            height: Math.round(bars.height * (index + 2) / 5)
            radius: Theme.size.hairline
            color: index < bars.quality ? Theme.color.secondaryInk : Theme.color.line
        }
    }
}
