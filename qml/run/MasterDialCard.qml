// SPDX-License-Identifier: Apache-2.0
// The live angle of a cam's master.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Plot

Card {
    id: card

    Label {
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: angle.left; rightMargin: Theme.size.spacing; verticalCenter: angle.verticalCenter }
        text: qsTr("Master")
        fontSizeMode: Text.HorizontalFit
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: angle
        anchors { right: parent.right; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.outline }
        text: isNaN(Controller.live.masterAngleDeg) ? Theme.unknownText : Theme.number(Controller.live.masterAngleDeg, 0) + "°"
        color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
        font { pixelSize: Theme.size.value; bold: true }
    }
    KnifeDial {
        objectName: "knifeDial"
        anchors { left: parent.left; right: parent.right; top: angle.bottom; bottom: parent.bottom; margins: Theme.size.spacing; topMargin: 0 }
        angleDeg: Controller.live.masterAngleDeg
        stale: !Controller.fresh
        ringColor: Theme.color.line
        handColor: Theme.color.ink
        tipColor: Theme.color.touch
        surfaceColor: Theme.color.surface
        staleColor: Theme.color.target
    }
}
