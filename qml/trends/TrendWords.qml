// SPDX-License-Identifier: Apache-2.0
// The names, units and decimals of the trend quantities.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

QtObject {
    readonly property var titles: [qsTr("Bag length mm"), qsTr("Deviation mm"), qsTr("Mark error mm"), qsTr("Following error mm"),
        qsTr("Rate bags/min"), qsTr("Time of answers ms")]
    readonly property var notes: [qsTr("of each bag, of one length of it"), qsTr("of each bag from the length that was set"),
        qsTr("of each cut from its printed mark"), qsTr("of the knife, while it turns"), qsTr("of the master, 0 at standstill"),
        qsTr("of the controller to the panel's questions")]
    readonly property var decimals: [2, 2, 2, 2, 1, 1]
    readonly property var colors: [Theme.color.touch, Theme.color.touch, Theme.color.position, Theme.color.acceleration, Theme.color.frequency, Theme.color.jerk]
}
