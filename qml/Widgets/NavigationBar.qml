// SPDX-License-Identifier: Apache-2.0
// The pages at the left, and below them a bell while something wants attention that was put aside.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: bar

    required property int current
    required property bool attention
    signal chosen(int page)
    signal attentionRequested()

    // `page` as the frame numbers them; from top to bottom as they stand here.
    readonly property var pages: [
        { page: 0, text: qsTr("Run"), glyph: Theme.icon.run },
        { page: 1, text: qsTr("Motion"), glyph: Theme.icon.motion },
        { page: 3, text: qsTr("Service"), glyph: Theme.icon.service },
        { page: 2, text: qsTr("Settings"), glyph: Theme.icon.settings }
    ]

    implicitWidth: Theme.size.navigation
    color: Theme.color.surface

    Rectangle {
        anchors.right: parent.right
        width: Theme.size.hairline
        height: parent.height
        color: Theme.color.line
    }
    Column {
        width: parent.width
        Repeater {
            model: bar.pages
            NavButton {
                required property var modelData
                objectName: "nav" + modelData.page
                width: bar.width - Theme.size.hairline
                height: Theme.size.navigation
                text: modelData.text
                glyph: modelData.glyph
                checked: bar.current === modelData.page
                onClicked: bar.chosen(modelData.page)
            }
        }
    }
    NavButton {
        objectName: "attention"
        anchors.bottom: parent.bottom
        visible: bar.attention
        width: bar.width - Theme.size.hairline
        height: Theme.size.navigation
        text: qsTr("Alarm")
        glyph: Theme.icon.alarm
        accentColor: Theme.color.fault
        checked: true
        onClicked: bar.attentionRequested()
    }
}
