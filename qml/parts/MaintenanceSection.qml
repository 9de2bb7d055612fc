// SPDX-License-Identifier: Apache-2.0
// The base of a section of the Maintenance page; visible or not.
pragma ComponentBehavior: Bound
import QtQuick

Item {
    id: section

    signal shownChanged(bool shown)

    onVisibleChanged: section.shownChanged(visible)
    Component.onCompleted: section.shownChanged(visible)
    Component.onDestruction: section.shownChanged(false)
}
