// SPDX-License-Identifier: Apache-2.0
// A linear axis or a ram from the side: motor, spindle, carriage. The parts of `marked` are in the color of what is touched.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: drawing

    property var marked: []                // "motor", "feed", "load"

    readonly property real middle: Math.round(height * 0.4)
    readonly property real thread: Math.round(width * 0.09)

    function has(part: string): bool {
        return drawing.marked.includes(part)
    }

    Rectangle { // the spindle
        x: motor.width
        y: drawing.middle - height / 2
        width: drawing.width - x
        height: 3 * Theme.size.accent
        color: Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.target }
    }
    Repeater { // one turn of the thread each
        model: Math.floor((drawing.width - motor.width) / drawing.thread)
        Rectangle {
            required property int index
            x: motor.width + (index + 0.5) * drawing.thread
            y: drawing.middle - height / 2
            width: Theme.size.outline
            height: 4 * Theme.size.accent
            rotation: 20
            color: drawing.has("feed") ? Theme.color.touch : Theme.color.target
        }
    }
    DrawingPart {
        id: motor
        y: drawing.middle - height / 2
        width: drawing.width * 0.18
        height: drawing.height * 0.34
        marked: drawing.has("motor")
        DrawingMark {
            anchors.centerIn: parent
            letter: "K"
            marked: motor.marked
        }
    }
    DrawingPart {
        x: drawing.width * 0.5
        y: drawing.middle - height / 2
        width: drawing.width * 0.2
        height: drawing.height * 0.44
        marked: drawing.has("load")
    }
    Dimension {
        x: motor.width + 1.5 * drawing.thread
        y: drawing.middle + drawing.height * 0.24
        width: drawing.thread
        letter: ""
        marked: drawing.has("feed")
    }
    DrawingMark {
        x: motor.width + 2 * drawing.thread - width / 2
        y: drawing.middle + drawing.height * 0.24 + 6 * Theme.size.accent
        letter: "p"
        marked: drawing.has("feed")
    }
}
