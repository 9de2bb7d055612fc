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
    readonly property string frequency: Theme.joined(Theme.count(Controller.live.pulseFrequencyHz, 0), "Hz")
    readonly property string speeds: !Controller.fresh ? "" : isNaN(Controller.live.knifeSpeedMmPerS) ? section.frequency
        : Theme.measure(Controller.live.knifeSpeedMmPerS, 1, "mm/s") + " · " + section.frequency
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
        NumberCard {
            readonly property bool known: !isNaN(Controller.live.position)
            objectName: "jogPosition"
            width: values.cell
            pixelSize: Theme.size.title
            title: known && Controller.live.positionUnit === "°" ? qsTr("Knife angle") : qsTr("Position")
            value: known ? Controller.live.position : section.jog.positionPulses
            unit: known ? Controller.live.positionUnit : qsTr("pulses")
            decimals: !known ? 0 : Controller.live.positionUnit === "°" ? 1 : 2
        }
        NumberCard {
            objectName: "jogState"
            width: values.cell
            pixelSize: Theme.size.title
            title: section.speeds.length > 0 ? section.speeds : qsTr("State")
            text: Controller.stateText
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
            level: Access.Technician
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
            level: Access.Technician
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
