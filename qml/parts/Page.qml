// SPDX-License-Identifier: Apache-2.0
// The base of every page: its requests to the frame.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

Item {
    property real bottomInset              // height of a banner at the lower edge
    // The space that the banner leaves free on the left and below, for the object that it mentions.
    property real bannerLeft
    property real bannerBottom
    property real leftInset                // width of what stands beside the page at the left: a sheet or its keypad
    property bool covered                  // a sheet, a keypad or the login is above it
    property Component firstSheet: null    // of the next step, opened with the page after the first start

    signal editRequested(var fields, int index, Item source)
    signal explainRequested(EditorField field)
    // Requests one sheet for several quantities of Explanations.
    signal numbersExplainRequested(var quantities)
    // Requests one sheet with that title for a list of Explanation.
    signal explanationsRequested(string title, var explanations)
    signal sheetRequested(Component sheet)
    signal pageRequested(string name)
}
