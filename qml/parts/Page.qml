// SPDX-License-Identifier: Apache-2.0
// The base of every page: the room that the frame leaves it.
pragma ComponentBehavior: Bound
import QtQuick

Item {
    property real bottomInset              // height of a banner at the lower edge
    // The space that the banner leaves free on the left and below, for the object that it mentions.
    property real bannerLeft
    property real bannerBottom
    property real bannerRow                // height of the cards whose place the banner takes; 0: the page makes room
    property bool showsFault               // a fault stands on the page itself: no banner tells it again
    property real leftInset                // width of what stands beside the page at the left: a sheet or its keypad

    // The page was opened, or its key touched again.
    function begin(): void { }
    // Shows the section of this file; a page without sections has none.
    function open(section: string): void { }
}
