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

    readonly property var pages: [
        { text: qsTr("Run"), glyph: Theme.icon.run },
        { text: qsTr("Motion"), glyph: Theme.icon.motion },
        { text: qsTr("Settings"), glyph: Theme.icon.settings }
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
                required property int index
                required property var modelData
                objectName: "nav" + index
                width: bar.width - Theme.size.hairline
                height: Theme.size.navigation
                text: modelData.text
                glyph: modelData.glyph
                checked: bar.current === index
                onClicked: bar.chosen(index)
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
