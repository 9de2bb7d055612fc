// SPDX-License-Identifier: Apache-2.0
// The knife's live angle with the arc of synchronous motion.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Plot

Card {
    id: card

    Rectangle {
        id: mark
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: angle.verticalCenter }
        width: Theme.size.icon / 2
        height: Theme.size.spacing
        color: Theme.color.sync
    }
    Label {
        anchors { left: mark.right; leftMargin: Theme.size.spacing; right: angle.left; verticalCenter: angle.verticalCenter }
        text: qsTr("Sync window")
        fontSizeMode: Text.HorizontalFit
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: angle
        anchors { right: parent.right; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.outline }
        text: isNaN(Controller.live.knifeAngleDeg) ? Theme.unknownText : Theme.number(Controller.live.knifeAngleDeg, 0) + "°"
        color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
        font { pixelSize: Theme.size.value; bold: true }
    }
    KnifeDial {
        objectName: "knifeDial"
        anchors { left: parent.left; right: parent.right; top: angle.bottom; bottom: parent.bottom; margins: Theme.size.spacing; topMargin: 0 }
        angleDeg: Controller.live.knifeAngleDeg
        syncStartDeg: Controller.active.syncStartDeg
        syncEndDeg: Controller.active.syncEndDeg
        cutAngleDeg: Controller.active.cutAngleDeg
        stale: !Controller.fresh
        ringColor: Theme.color.line
        syncColor: Theme.color.sync
        cutColor: Theme.color.ink
        handColor: Theme.color.ink
        tipColor: Theme.color.touch
        surfaceColor: Theme.color.surface
        staleColor: Theme.color.target
    }
}
