// SPDX-License-Identifier: Apache-2.0
// The knife's speed over its target, with following error and torque.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Sheet {
    id: sheet

    objectName: "knifeSheet"
    title: qsTr("Knife")
    panelWidth: width * 0.9

    SpeedCard {
        anchors.fill: parent
        color: Theme.color.inset
        compact: Theme.size.name === "small"
        title: qsTr("Knife speed %1").arg(Theme.shownUnit("mm/s"))
    }
}
