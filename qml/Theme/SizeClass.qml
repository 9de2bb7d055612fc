// SPDX-License-Identifier: Apache-2.0
// Sizes of one screen class in pixels. Touch sizes come from millimeters and the density of the panel.
pragma ComponentBehavior: Bound
import QtQuick

QtObject {
    required property string name
    required property size screen         // the panel that this class is drawn for
    required property real diagonalInch
    required property int topBar
    required property int navigation
    required property int wideGap         // between cards and to the edge, for a bare finger
    required property int padding         // inside a card
    required property int radius
    required property int sideColumn      // the column of fields on the left
    required property int fieldColumns    // fields side by side in it
    required property int caption         // font sizes
    required property int body
    required property int title
    required property int value
    required property int hero
    required property int command
    required property int icon
    required property int largeIcon
    required property int handle          // visible diameter of a curve handle
    required property int mark            // state dots, accents
    required property int curve           // width of a drawn curve

    property real pixelsPerMm: Math.hypot(screen.width, screen.height) / diagonalInch / 25.4
    property real reach: 1                // scale of touch targets: 1 for a bare finger
    readonly property int smallestText: screen.width < 1000 ? 10 : 12   // a longer text wraps or is elided
    readonly property int hairline: 1
    readonly property int outline: 2
    readonly property int accent: 4
    // Font size of a number that is read from three metres: its digits are 14 mm high, and on a large screen more.
    readonly property int distant: Math.max(Math.round(14 * pixelsPerMm / digitShare), Math.round(1.5 * hero))
    readonly property real digitShare: 0.714   // of the font size: the height of a digit of Noto Sans
    // 12 and 18 mm, and never too small for their texts: a large screen is read from a distance.
    readonly property int touch: Math.max(Math.round(12 * reach * pixelsPerMm), Math.round(3.9 * body))
    readonly property int commandKey: Math.max(Math.floor(18 * reach * pixelsPerMm), Math.floor(3.75 * command))
    readonly property int keypad: 4 * commandKey + 2 * accent   // width of the keypad for numbers
    // Larger keys take their space from the gaps.
    readonly property int gap: reach > 1 ? Math.round(wideGap / 3) : wideGap
    readonly property int spacing: Math.round(padding / (reach > 1 ? 4 : 2))
    readonly property int actionBar: touch + 2 * spacing + hairline * 4
}
