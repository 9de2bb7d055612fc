// SPDX-License-Identifier: Apache-2.0
// A rotary cutter from the side: motor, gear, knife shaft, film with its printed marks, mark sensor. The parts of `marked`
// are in the color of what is touched.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: drawing

    property var marked: []                // "radius", "knives", "motor", "gear", "contact", "film", "sensor", "offset"
    property int knives: 1
    property bool showsBags                // behind the knife
    property real offset: 0                // from a mark to its cut, of a bag length

    readonly property real filmY: Math.round(height * 0.76)
    readonly property real radius: Math.round(Math.min(width * 0.22, height * 0.32))
    readonly property real knifeX: Math.round(width * 0.62)
    readonly property real shaftY: filmY - radius
    readonly property real sensorX: Math.round(width * 0.1)
    readonly property real bag: width * 0.17
    readonly property int contactDeg: 24   // of the jaws, as drawn

    function has(part: string): bool {
        return drawing.marked.includes(part)
    }
    function ink(part: string): color {
        return drawing.has(part) ? Theme.color.touch : Theme.color.secondaryInk
    }

    Rectangle { // the shafts of motor and gear
        x: motor.x + motor.width
        y: drawing.shaftY - height / 2
        width: drawing.knifeX - x
        height: Theme.size.accent
        color: Theme.color.target
    }
    DrawingPart {
        id: motor
        x: 0
        y: drawing.shaftY - height / 2
        width: drawing.width * 0.16
        height: drawing.radius
        marked: drawing.has("motor")
        DrawingMark {
            anchors.centerIn: parent
            letter: "K"
            marked: motor.marked
        }
    }
    DrawingPart {
        id: gear
        x: drawing.width * 0.22
        y: drawing.shaftY - height / 2
        width: drawing.width * 0.11
        height: drawing.radius * 1.3
        marked: drawing.has("gear")
        DrawingMark {
            anchors.centerIn: parent
            letter: "Z"
            marked: gear.marked
        }
    }
    Rectangle { // the circle of the knife edges
        x: drawing.knifeX - drawing.radius
        y: drawing.shaftY - drawing.radius
        width: 2 * drawing.radius
        height: width
        radius: drawing.radius
        color: Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.target }
    }
    Repeater { // the knives, the first one in the film
        model: Math.max(1, Math.min(12, drawing.knives))
        Rectangle {
            required property int index
            x: drawing.knifeX - width / 2
            y: drawing.shaftY
            width: drawing.has("knives") ? 2 * Theme.size.accent : Theme.size.accent
            height: drawing.radius
            transformOrigin: Item.Top
            rotation: index * 360 / drawing.knives
            color: drawing.has("knives") ? Theme.color.touch : Theme.color.target
        }
    }
    Repeater { // the arc in which the jaws touch the film
        model: drawing.has("contact") ? 2 : 0
        Rectangle {
            required property int index
            x: drawing.knifeX - width / 2
            y: drawing.shaftY
            width: Theme.size.outline
            height: drawing.radius
            transformOrigin: Item.Top
            rotation: (index - 0.5) * drawing.contactDeg
            color: Theme.color.touch
        }
    }
    Rectangle {
        x: drawing.knifeX - width / 2
        y: drawing.shaftY - drawing.radius
        width: drawing.has("radius") ? Theme.size.accent : Theme.size.outline
        height: drawing.radius
        color: drawing.ink("radius")
    }
    DrawingMark {
        x: drawing.knifeX - width / 2
        y: drawing.shaftY - drawing.radius / 2 - height / 2
        letter: "R"
        marked: drawing.has("radius")
    }
    DrawingMark {
        x: Math.min(drawing.width - width, drawing.knifeX + drawing.radius * 0.75)
        y: Math.max(0, drawing.shaftY - drawing.radius)
        letter: "N = " + drawing.knives
        marked: drawing.has("knives")
    }
    Rectangle {
        y: drawing.filmY
        width: drawing.showsBags ? drawing.knifeX : drawing.width
        height: Theme.size.accent
        color: drawing.ink("film")
    }
    Repeater { // bags behind the knife
        model: drawing.showsBags ? 2 : 0
        Rectangle {
            required property int index
            x: drawing.knifeX + index * drawing.bag + Theme.size.accent
            y: drawing.filmY
            width: drawing.bag - Theme.size.accent
            height: Theme.size.accent
            color: drawing.ink("film")
        }
    }
    Repeater { // printed marks
        model: 5
        Rectangle {
            required property int index
            x: drawing.knifeX + (index - 3 - drawing.offset) * drawing.bag - width / 2
            y: drawing.filmY - height / 2 + Theme.size.outline
            width: Theme.size.accent
            height: 3 * Theme.size.accent
            color: Theme.color.ink
        }
    }
    Rectangle { // the mark sensor
        x: drawing.sensorX - width / 2
        y: drawing.filmY - height - 2 * Theme.size.accent
        width: 3 * Theme.size.accent
        height: 4 * Theme.size.accent
        color: drawing.ink("sensor")
    }
    Dimension {
        x: drawing.sensorX
        y: drawing.filmY + 3 * Theme.size.accent
        width: drawing.knifeX - x
        letter: "D"
        marked: drawing.has("sensor")
    }
    Dimension {
        visible: drawing.has("offset") && drawing.offset > 0
        x: drawing.knifeX + (1 - drawing.offset) * drawing.bag
        y: drawing.filmY + 3 * Theme.size.accent
        width: drawing.offset * drawing.bag
        letter: ""
        marked: true
    }
}
