// SPDX-License-Identifier: Apache-2.0
// The names of all colors; a scheme (light, dark, high contrast) gives them values. Nothing outside this folder names a color.
pragma ComponentBehavior: Bound
import QtQuick

QtObject {
    required property bool dark
    required property real textContrast       // minimum contrast of a text with its background, 1 to 21
    required property real largeTextContrast  // the same for texts of 24 px, bold from 19 px
    required property color ground        // behind the cards
    required property color surface       // cards, bars
    required property color inset         // fields and plots inside a card
    required property color ink
    required property color secondaryInk
    required property color line          // hairlines, borders
    required property color touch         // touchable or live elements
    required property color touchTint     // its background
    required property color touchInk      // text on it
    required property color touchPressed
    required property color good
    required property color warning
    required property color fault
    required property color stop
    required property color stopPressed
    required property color stopEdge
    required property color stopInk
    required property color target        // target curve, ring of the dial
    required property color sync          // the knife's synchronous range
    required property color disabledInk
    required property color scrim
    // Quantities are told apart by their titles: blue and greys, for red and amber are for the abnormal and green for states.
    required property color acceleration
    required property color frequency
    required property color position
    required property color jerk
}
