// SPDX-License-Identifier: Apache-2.0
// A shift as a bar of states over its hours. Each kind of state has a color and a height of its own.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    // By BarRow::Kind.
    readonly property list<color> colors: [Theme.color.sync, Theme.color.secondaryInk, Theme.color.warning, Theme.color.touch, Theme.color.fault]
    readonly property list<real> heights: [1, 0.4, 0.55, 0.25, 0.75]
    readonly property list<string> names: [qsTr("Running"), qsTr("Stopped"), qsTr("Waiting"), qsTr("Manual"), qsTr("Fault")]

    Rectangle {
        id: bar
        objectName: "stateBar"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: hours.top; margins: Theme.size.padding; bottomMargin: 0 }
        color: Theme.color.inset
        Repeater {
            model: Stops.shift.bar
            Rectangle {
                required property real from
                required property real share
                required property int kind
                x: Math.round(from * bar.width)
                y: bar.height - height
                width: Math.max(1, Math.round((from + share) * bar.width) - x)
                height: Math.round(card.heights[kind] * bar.height)
                color: card.colors[kind]
            }
        }
        Rectangle {
            anchors.bottom: parent.bottom
            width: parent.width
            height: Theme.size.hairline
            color: Theme.color.line
        }
    }
    Item {
        id: hours
        anchors { left: bar.left; right: bar.right; bottom: legend.top }
        height: Theme.size.caption * 1.4
        readonly property int every: Math.max(1, Math.ceil(Stops.shift.hours.length * 4 * Theme.size.caption / Math.max(1, width)))
        Repeater {
            model: Stops.shift.hours
            Label {
                required property int index
                required property var modelData
                visible: index % hours.every === 0
                x: Math.min(hours.width - width, Math.max(0, modelData.at * hours.width - width / 2))
                text: modelData.text
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
    Row {
        id: legend
        anchors { left: bar.left; right: bar.right; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        height: Theme.size.caption * 1.4
        Repeater {
            model: card.names.length
            Row {
                required property int index
                width: legend.width / card.names.length
                height: legend.height
                spacing: Theme.size.accent
                Rectangle {
                    y: parent.height - height - Theme.size.accent / 2
                    width: Theme.size.mark
                    height: card.heights[parent.index] * Theme.size.mark
                    color: card.colors[parent.index]
                }
                Label {
                    width: parent.width - Theme.size.mark - 2 * Theme.size.accent
                    fontSizeMode: Text.HorizontalFit
                    text: card.names[parent.index]
                    color: Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
        }
    }
}
