// SPDX-License-Identifier: Apache-2.0
// The knife of the machine and the bag that it has cut, drawn to the same scale.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: drawing

    readonly property EditorField knife: Editor.field("knife_radius_mm")
    readonly property EditorField bag: Editor.field("bag_length_mm")
    // Pixels per unit of both; the bag begins below the shaft.
    readonly property real pixels: Math.min(width / Math.max(2 * knife.value, knife.value + bag.value), 0.95 * (height - length.height - bagHeight) / knife.value / 2)
    readonly property real radius: Math.max(Theme.size.outline, knife.value * pixels)
    readonly property real bagLength: Math.max(Theme.size.outline, bag.value * pixels)
    readonly property real bagHeight: Math.min(0.2 * height, 0.5 * Theme.size.touch)
    readonly property real leftX: (width - Math.max(2 * radius, radius + bagLength)) / 2
    readonly property real shaftX: leftX + radius
    readonly property real filmY: height - length.height - bagHeight

    Accessible.role: Accessible.Graphic
    Accessible.name: qsTr("Knife and bag, to scale")

    Rectangle { // the circle of the knife edges
        x: drawing.leftX
        y: drawing.filmY - height
        width: 2 * drawing.radius
        height: width
        radius: drawing.radius
        color: Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.target }
    }
    Rectangle { // the knife, in the film
        x: drawing.shaftX - width / 2
        y: drawing.filmY - drawing.radius
        width: Theme.size.accent
        height: drawing.radius
        color: Theme.color.target
    }
    Rectangle { // the film in front of the knife
        y: drawing.filmY
        width: drawing.shaftX - Theme.size.outline
        height: Theme.size.accent
        color: Theme.color.secondaryInk
    }
    DrawingPart {
        x: drawing.shaftX
        y: drawing.filmY
        width: drawing.bagLength
        height: drawing.bagHeight
        marked: true
    }
    Dimension {
        id: length
        x: drawing.shaftX
        y: drawing.height - height
        width: drawing.bagLength
        letter: Theme.joined(drawing.bag.text, drawing.bag.unit)
        marked: true
    }
}
