// SPDX-License-Identifier: Apache-2.0
// The knife's live angle with the arc where it runs with the film.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Machine
import CamPanel.Plot

Card {
    id: card

    KnifeDial {
        id: dial
        anchors { fill: parent; margins: Theme.size.padding }
        angleDeg: Machine.knifeAngleDeg
        syncStartDeg: Machine.syncStartDeg
        syncEndDeg: Machine.syncEndDeg
        cutAngleDeg: Machine.cutAngleDeg
        stale: !Machine.fresh
        ringColor: Theme.color.line
        syncColor: Theme.color.target
        cutColor: Theme.color.ink
        handColor: Theme.color.ink
        tipColor: Theme.color.touch
        surfaceColor: Theme.color.surface
        staleColor: Theme.color.target
    }
    Label {
        anchors { horizontalCenter: dial.horizontalCenter; verticalCenter: dial.verticalCenter; verticalCenterOffset: -dial.height * 0.19 }
        text: isNaN(Machine.knifeAngleDeg) ? Theme.unknownText : Theme.number(Machine.knifeAngleDeg, 0) + "°"
        color: Machine.fresh ? Theme.color.ink : Theme.color.disabledInk
        font { pixelSize: Theme.size.value; bold: true }
    }
    Label {
        anchors { horizontalCenter: dial.horizontalCenter; verticalCenter: dial.verticalCenter; verticalCenterOffset: dial.height * 0.22 }
        text: Machine.hasActiveProgram ? qsTr("Sync window") : qsTr("Knife")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
