// SPDX-License-Identifier: Apache-2.0
// Jog: two keys that move the axis while they are held, its position, and a sentence about the movement or why there is
// none. Removing the keys from the screen stops the axis.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property Jog jog: Maintenance.jog
    readonly property bool cutter: Controller.active.kind === Editor.Kind.RotaryCutter && !isNaN(Controller.live.knifeAngleDeg)
    readonly property bool covered: Frame.covered
    readonly property bool inFront: Window.active

    onShownChanged: shown => {
        if (!shown)
            section.jog.letGo()
    }
    onCoveredChanged: {
        if (covered)
            section.jog.letGo()
    }
    onInFrontChanged: {
        if (!inFront)
            section.jog.letGo()
    }

    Row {
        id: values
        readonly property real cell: (width - 2 * spacing) / 3
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        PositionTile {
            objectName: "jogPosition"
            width: values.cell
            stale: !Controller.fresh
            label: section.cutter ? qsTr("Knife angle") : qsTr("Position")
            value: section.cutter ? Theme.number(Controller.live.knifeAngleDeg, 1) + "°"
                : isNaN(Controller.live.positionMm) ? qsTr("%1 pulses").arg(Theme.count(section.jog.positionPulses, 0))
                : qsTr("%1 mm").arg(Theme.number(Controller.live.positionMm, 2))
        }
        PositionTile {
            objectName: "jogState"
            width: values.cell
            stale: !Controller.fresh
            label: Controller.fresh ? qsTr("%1 Hz now").arg(Theme.count(Controller.live.pulseFrequencyHz, 0)) : qsTr("State")
            value: Controller.stateText
        }
        ParameterTile {
            id: speed
            objectName: "jogSpeed"
            width: values.cell
            name: "parameter.jog_frequency"
        }
    }
    Row {
        id: line
        anchors { left: parent.left; right: parent.right; top: values.bottom; topMargin: Theme.size.spacing }
        height: 2 * Theme.size.title + Theme.size.spacing
        spacing: Theme.size.spacing
        IconLabel {
            id: sign
            anchors.verticalCenter: parent.verticalCenter
            code: section.jog.blocked ? Theme.icon.alert : section.jog.held !== 0 ? Theme.icon.moving : Theme.icon.information
            color: section.jog.blocked ? Theme.color.warning : section.jog.held !== 0 ? Theme.color.touch : Theme.color.secondaryInk
        }
        Label {
            objectName: "jogText"
            width: parent.width - sign.width - parent.spacing
            height: parent.height
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            minimumPixelSize: Theme.size.caption - 2
            text: speed.field.failure.length > 0 ? speed.field.failure : section.jog.text
            color: section.jog.blocked || speed.field.failure.length > 0 ? Theme.color.warning : Theme.color.ink
        }
    }
    Row {
        id: keys
        anchors { left: parent.left; right: parent.right; top: line.bottom; bottom: parent.bottom; topMargin: Theme.size.spacing }
        spacing: 2 * Theme.size.gap
        JogKey {
            objectName: "jogReverse"
            width: (keys.width - keys.spacing) / 2
            height: keys.height
            jog: section.jog
            direction: -1
            glyph: Theme.icon.jogReverse
            text: qsTr("Reverse")
            note: section.jog.reverseNote
        }
        JogKey {
            objectName: "jogForward"
            width: (keys.width - keys.spacing) / 2
            height: keys.height
            jog: section.jog
            direction: 1
            glyph: Theme.icon.jogForward
            text: qsTr("Forward")
            note: section.jog.forwardNote
        }
    }
}
