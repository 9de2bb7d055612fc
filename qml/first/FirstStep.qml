// SPDX-License-Identifier: Apache-2.0
// Base of a step of the first start: it knows the page to ask for keypad and sheets.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts

Item {
    property Page page
}
