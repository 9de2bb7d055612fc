// SPDX-License-Identifier: Apache-2.0
// The pages on the left; on a low screen the last ones are behind the key More. The key of the alarms counts those that need
// to be acknowledged.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Rectangle {
    id: bar

    required property int current
    signal chosen(int page)
    signal moreChosen()

    // The pages from top to bottom; `page` is the number in the frame.
    readonly property var pages: [
        { page: 0, text: qsTr("Run"), glyph: Theme.icon.run },
        { page: 1, text: qsTr("Motion"), glyph: Theme.icon.motion },
        { page: 4, text: qsTr("Recipes"), glyph: Theme.icon.recipes },
        { page: 5, text: qsTr("Trends"), glyph: Theme.icon.trends },
        { page: 6, text: qsTr("Alarms"), glyph: Theme.icon.alarm },
        { page: 3, text: qsTr("Maintenance"), glyph: Theme.icon.service },
        { page: 2, text: qsTr("Settings"), glyph: Theme.icon.settings }
    ]

    // Seven pages fit into the height of each screen with keys for a finger, but not always for a glove.
    readonly property bool fits: Math.floor(height / pages.length) >= Theme.size.touch
    readonly property int inFront: 5
    readonly property var pagesBehind: fits ? [] : pages.slice(inFront)
    // Without a height no keys: they would be created twice.
    readonly property var keys: height === 0 ? [] : fits ? pages : pages.slice(0, inFront).concat([{ page: -1, text: qsTr("More"), glyph: Theme.icon.more }])
    readonly property real keyHeight: Math.min(Math.max(Theme.size.navigation, Theme.size.touch), Math.floor(height / Math.max(1, keys.length)))

    implicitWidth: Math.max(Theme.size.navigation, Theme.size.touch + Theme.size.hairline)
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
            model: bar.keys
            NavButton {
                required property var modelData
                readonly property bool isMore: modelData.page < 0
                objectName: isMore ? "navMore" : "nav" + modelData.page
                width: bar.width - Theme.size.hairline
                height: bar.keyHeight
                text: modelData.text
                glyph: modelData.glyph
                checked: isMore ? bar.pagesBehind.some(behind => behind.page === bar.current) : bar.current === modelData.page
                calls: modelData.page === 6 ? Alarms.unacknowledged : 0
                callColor: Alarms.callingSeverity === Alarms.Severity.Fault ? Theme.color.fault : Theme.color.warning
                onClicked: isMore ? bar.moreChosen() : bar.chosen(modelData.page)
            }
        }
    }
}
