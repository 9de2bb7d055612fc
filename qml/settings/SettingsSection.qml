// SPDX-License-Identifier: Apache-2.0
// The base of a section of the Settings page: a title, and for a section within another one the way back.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: section

    required property string title
    property SettingsPage settings
    readonly property bool within: settings !== null && settings.shown !== settings.section
    readonly property real bodyTop: heading.height + Theme.size.spacing

    Button {
        id: back
        objectName: "sectionBack"
        anchors { right: parent.right; top: parent.top }
        visible: section.within
        glyph: Theme.icon.previous
        text: section.within ? section.settings.menu[section.settings.shown].text : ""
        onClicked: section.settings.section = section.settings.shown
    }
    Label {
        id: heading
        width: section.within ? back.x - Theme.size.spacing : parent.width
        height: section.within ? back.height : implicitHeight
        verticalAlignment: Text.AlignVCenter
        text: section.title
        font { pixelSize: Theme.size.title; bold: true }
    }
}
