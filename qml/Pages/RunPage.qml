// SPDX-License-Identifier: Apache-2.0
// Run: knife, rate, count, bag length, and the knife's speed over its target.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Widgets
import CamPanel.Machine

Page {
    id: page

    readonly property int gap: Theme.size.gap
    readonly property real upper: Math.round((height - gap) * 0.48)

    DialCard {
        id: dial
        width: page.upper
        height: page.upper
    }
    NumberCard {
        id: rate
        anchors { left: dial.right; leftMargin: page.gap }
        width: Math.round((page.width - dial.width - 2 * page.gap) * 0.37)
        height: (page.upper - page.gap) / 2
        value: Machine.rateBagsPerMin
        decimals: 1
        caption: qsTr("bags/min")
    }
    NumberCard {
        anchors { left: rate.left; right: rate.right; top: rate.bottom; topMargin: page.gap }
        height: rate.height
        value: Machine.bagCount
        decimals: 0
        caption: qsTr("bags")
    }
    BagCard {
        anchors { left: rate.right; leftMargin: page.gap; right: parent.right }
        height: page.upper
    }
    SpeedCard {
        anchors { left: parent.left; right: parent.right; top: dial.bottom; topMargin: page.gap; bottom: parent.bottom; bottomMargin: page.bottomInset }
    }
}
