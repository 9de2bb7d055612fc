// SPDX-License-Identifier: Apache-2.0
// The base of a step of the first start, with access to the page for keypad and sheets.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts

Item {
    property Page page
}
