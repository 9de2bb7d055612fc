// SPDX-License-Identifier: Apache-2.0
// The present stop, or the last one, with its reason. A tap opens the stops of the shift.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

RunTile {
    id: card

    objectName: "lastStopCard"
    title: Stops.lastTitle || qsTr("No stop yet")
    onClicked: Frame.openPage("stops")

    Label {
        objectName: "lastStopReason"
        width: parent.width
        height: Math.max(Theme.size.caption, parent.height - duration.height)
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Stops.lastReason
        font { pixelSize: Theme.size.body; weight: Font.DemiBold }
    }
    Label {
        id: duration
        text: Stops.lastDuration
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
