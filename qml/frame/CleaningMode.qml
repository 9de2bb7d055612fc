// SPDX-License-Identifier: Apache-2.0
// The cover over everything that must not be touched during cleaning, for the time in Display.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Rectangle {
    color: Theme.color.surface

    MouseArea { anchors.fill: parent }
    Column {
        anchors.centerIn: parent
        width: parent.width - 2 * Theme.size.gap
        spacing: Theme.size.gap
        Label {
            objectName: "wipeCountdown"
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            text: qsTr("%1 s").arg(Display.wipeSeconds)
            font { pixelSize: Theme.size.hero; bold: true }
        }
        Label {
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.Wrap
            text: qsTr("Clean the screen now. The panel ignores touches until the time is over; Stop still works.")
        }
    }
}
