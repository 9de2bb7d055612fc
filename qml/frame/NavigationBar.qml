// SPDX-License-Identifier: Apache-2.0
// The pages on the left; on a low screen the last ones are behind the key More. The key of the alarms counts those that need
// to be acknowledged.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Rectangle {
    id: bar

    required property string current

    // The pages from top to bottom; `page` is the name in the frame.
    readonly property var pages: [
        { page: "run", text: qsTr("Run"), glyph: Theme.icon.run },
        { page: "motion", text: qsTr("Motion"), glyph: Theme.icon.motion },
        { page: "recipes", text: qsTr("Recipes"), glyph: Theme.icon.recipes },
        { page: "trends", text: qsTr("Trends"), glyph: Theme.icon.trends },
        { page: "alarms", text: qsTr("Alarms"), glyph: Theme.icon.alarm },
        { page: "maintenance", text: qsTr("Maintenance"), glyph: Theme.icon.service },
        { page: "settings", text: qsTr("Settings"), glyph: Theme.icon.settings }
    ]

    // Seven pages fit into the height of each screen with keys for a finger, but not always for a glove.
    readonly property bool fits: Math.floor(height / pages.length) >= Theme.size.touch
    readonly property int inFront: 5
    readonly property var pagesBehind: fits ? [] : pages.slice(inFront)
    // Without a height no keys: they would be created twice.
    readonly property var keys: height === 0 ? [] : fits ? pages : pages.slice(0, inFront).concat([{ page: "more", text: qsTr("More"), glyph: Theme.icon.more }])
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
                readonly property bool isMore: modelData.page === "more"
                objectName: "nav_" + modelData.page
                width: bar.width - Theme.size.hairline
                height: bar.keyHeight
                text: modelData.text
                glyph: modelData.glyph
                // Stops is opened from Trends and has no key of its own.
                checked: isMore ? bar.pagesBehind.some(behind => behind.page === bar.current) : bar.current === modelData.page || (modelData.page === "trends" && bar.current === "stops")
                calls: modelData.page === "alarms" ? Alarms.unacknowledged : 0
                callColor: Alarms.callingSeverity === Alarms.Severity.Fault ? Theme.color.fault : Theme.color.warning
                onClicked: isMore ? Frame.open("Frame/PagesSheet", { pages: bar.pagesBehind, current: bar.current }) : Frame.openPage(modelData.page)
            }
        }
    }
}
