// SPDX-License-Identifier: Apache-2.0
// The names, units and decimals of the trend quantities.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

QtObject {
    readonly property string length: Theme.shownUnit("mm")
    readonly property var titles: [qsTr("Bag length %1").arg(length), qsTr("Deviation %1").arg(length), qsTr("Mark error %1").arg(length), qsTr("Following error %1").arg(length),
        qsTr("Rate bags/min"), qsTr("Response time ms"), qsTr("Residue %")]
    readonly property var notes: [qsTr("each bag, per bag length"), qsTr("each bag against the set length"),
        qsTr("each cut against its printed mark"), qsTr("knife, while turning"), qsTr("master, 0 at standstill"),
        qsTr("controller to the panel's requests"), qsTr("torque at the cut, 1000 bags")]
    readonly property var metricUnits: ["mm", "mm", "mm", "mm", "", "", ""]
    readonly property var decimals: [2, 2, 2, 2, 1, 1, 2]
    readonly property var colors: [Theme.color.touch, Theme.color.touch, Theme.color.position, Theme.color.acceleration, Theme.color.frequency, Theme.color.jerk, Theme.color.position]
}
