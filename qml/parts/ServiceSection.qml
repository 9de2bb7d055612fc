// SPDX-License-Identifier: Apache-2.0
// Base of a section of the Service page: it knows the page to ask for keypad and sheets, and whether it is on the screen.
pragma ComponentBehavior: Bound
import QtQuick

Item {
    id: section

    property Page page
    signal shownChanged(bool shown)

    onVisibleChanged: section.shownChanged(visible)
    Component.onCompleted: section.shownChanged(visible)
    Component.onDestruction: section.shownChanged(false)
}
