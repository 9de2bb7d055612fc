// SPDX-License-Identifier: Apache-2.0
// The reference run: the state of the axis position, the effect of the key on this machine, and the last result.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property Homing homing: Maintenance.homing
    readonly property bool good: section.homing.place === Homing.Place.Homed || section.homing.place === Homing.Place.NotNeeded

    onShownChanged: shown => {
        if (shown)
            section.homing.open()
    }

    Row {
        id: state
        anchors { left: parent.left; right: key.left; rightMargin: Theme.size.padding; top: parent.top }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        IconLabel {
            id: sign
            anchors.verticalCenter: parent.verticalCenter
            code: section.good ? Theme.icon.check : section.homing.place === Homing.Place.NotHomed ? Theme.icon.information : Theme.icon.unknown
            color: section.good ? Theme.color.good : section.homing.place === Homing.Place.NotHomed ? Theme.color.touch : Theme.color.disabledInk
        }
        Label {
            objectName: "homingPlace"
            width: parent.width - sign.width - parent.spacing
            height: parent.height
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.body
            text: section.homing.placeText
            color: section.homing.place === Homing.Place.Unknown ? Theme.color.disabledInk : Theme.color.ink
            font { pixelSize: Theme.size.value; bold: true }
        }
    }
    Label {
        id: explanation
        objectName: "homingExplanation"
        anchors { left: parent.left; right: key.left; rightMargin: Theme.size.padding; top: state.bottom; bottom: result.top; bottomMargin: Theme.size.spacing }
        wrapMode: Text.WordWrap
        verticalAlignment: Text.AlignTop
        fontSizeMode: Text.Fit
        text: section.homing.explanation
    }
    Label {
        id: result
        objectName: "homingResult"
        anchors { left: parent.left; right: key.left; rightMargin: Theme.size.padding; bottom: speed.top; bottomMargin: Theme.size.spacing }
        wrapMode: Text.WordWrap
        text: speedTile.field.failure.length > 0 ? speedTile.field.failure
            : !section.homing.possible ? section.homing.blockedReason : section.homing.resultText
        color: section.homing.failed || !section.homing.possible || speedTile.field.failure.length > 0 ? Theme.color.warning : Theme.color.good
        font.weight: Font.DemiBold
    }
    Row {
        id: speed
        readonly property real cell: (width - spacing) / 2
        anchors { left: parent.left; right: key.left; rightMargin: Theme.size.padding; bottom: parent.bottom }
        spacing: Theme.size.spacing
        NumberCard {
            objectName: "homingPosition"
            width: speed.cell
            pixelSize: Theme.size.title
            title: qsTr("Position from reference")
            value: section.good ? Controller.live.position : NaN
            unit: Controller.live.positionUnit
            decimals: Controller.live.positionUnit === "°" ? 1 : 2
        }
        ParameterTile {
            id: speedTile
            objectName: "homingSpeed"
            visible: section.homing.moves
            width: speed.cell
            name: "parameter.home_frequency"
        }
    }
    CommandKey {
        id: key
        objectName: "homingKey"
        level: Access.Operator
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
        visible: section.homing.possible && !section.homing.offered   // else the command column has it
        width: visible ? Math.round(1.6 * Theme.size.commandKey) : 0
        glyph: Theme.icon.referenceRun
        text: section.homing.keyText
        onCommanded: section.homing.home()
    }
}
