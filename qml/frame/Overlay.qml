// SPDX-License-Identifier: Apache-2.0
// The base of dialogs over a page: the part of the page that stays visible, and the request to close.
pragma ComponentBehavior: Bound
import QtQuick

Item {
    property real free                     // right end of the visible part
    property real besideRight              // left end of it; 0: the window's
    signal closed()
}
