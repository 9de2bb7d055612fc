// SPDX-License-Identifier: Apache-2.0
// The base of a section of the Service page, with access to the page for keypad and sheets; visible or not.
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
