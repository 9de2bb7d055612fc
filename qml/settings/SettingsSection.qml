// SPDX-License-Identifier: Apache-2.0
// The base of a section of the Settings page: a title, and access to the page for keypad and sheets.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts

Item {
    id: section

    required property string title
    property Page page
    readonly property real bodyTop: heading.height + Theme.size.spacing

    Label {
        id: heading
        width: parent.width
        text: section.title
        font { pixelSize: Theme.size.title; bold: true }
    }
}
