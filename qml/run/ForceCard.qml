// SPDX-License-Identifier: Apache-2.0
// The force over the position of the newest stroke, with its end gate.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Plot

Card {
    id: card

    readonly property bool drawn: Controller.strokes.forceCurve.length > 1

    Label {
        id: caption
        anchors { left: parent.left; right: parent.right; top: parent.top; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        text: qsTr("Force N over position")
        fontSizeMode: Text.HorizontalFit
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    ForcePlot {
        id: plot
        objectName: "forcePlot"
        anchors { left: parent.left; right: parent.right; top: caption.bottom; bottom: key.top; margins: Theme.size.spacing; topMargin: Theme.size.outline; bottomMargin: 0 }
        curve: Controller.strokes.forceCurve
        fromPosition: Controller.active.approachPositionMm
        gatePosition: Controller.active.pressPositionMm
        gateLow: Controller.active.minStopForceN
        gateHigh: Controller.active.maxStopForceN
        gridColor: Theme.color.line
        secondaryInkColor: Theme.color.secondaryInk
        curveColor: Controller.fresh ? Theme.color.touch : Theme.color.disabledInk
        gateColor: Theme.color.secondaryInk
        lineWidth: Theme.size.curve
        axisFont: Theme.captionFont
        positionUnit: Theme.shownUnit("mm")
        positionFactor: Theme.unitFactor("mm")
        Binding {
            target: plot
            property: "locale"
            value: Theme.locale
        }
    }
    Label {
        anchors { left: plot.left; right: plot.right; verticalCenter: plot.verticalCenter; margins: Theme.size.icon }
        visible: !card.drawn
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Controller.run.stroke
        color: Theme.color.secondaryInk
    }
    Label {
        id: key
        objectName: "gateText"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; bottomMargin: Theme.size.spacing }
        fontSizeMode: Text.HorizontalFit
        text: Theme.fill(qsTr("at the stop: %1, %2 to %3"), [Theme.measure(Controller.active.pressPositionMm, 2, "mm"), Theme.number(Controller.active.minStopForceN, 0), Theme.measure(Controller.active.maxStopForceN, 0, "N")])
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
