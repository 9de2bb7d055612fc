// SPDX-License-Identifier: Apache-2.0
// Base of every page: what a page may ask of the frame around it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Machine

Item {
    property real bottomInset              // taken by a banner at the lower edge
    // What the banner leaves free at the left and below: what it asks for may be there.
    property real bannerLeft
    property real bannerBottom
    property bool covered                  // a sheet, a keypad or the login lies above it

    signal editRequested(var fields, int index, Item source)
    signal explainRequested(EditorField field)
    // Some of Explanations, told in one sheet.
    signal numbersExplainRequested(var quantities)
    // A list of Explanation, told in one sheet of that title.
    signal explanationsRequested(string title, var explanations)
    signal sheetRequested(Component sheet)
}
