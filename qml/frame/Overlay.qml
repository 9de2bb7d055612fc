// SPDX-License-Identifier: Apache-2.0
// Base of what lies over a page: how much of the page it leaves free, and the wish to be closed.
pragma ComponentBehavior: Bound
import QtQuick

Item {
    property real free                     // right end of what stays visible
    signal closed()
}
