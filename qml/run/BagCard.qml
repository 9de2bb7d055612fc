// SPDX-License-Identifier: Apache-2.0
// The last bag's length, and the last sixty as points in the tolerance band.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

Card {
    id: card

    readonly property bool measured: Controller.bags.counted > 0
    readonly property bool scrap: Controller.bags.isScrap
    readonly property color figureColor: Controller.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk

    IconLabel {
        anchors { right: parent.right; top: parent.top; margins: Theme.size.spacing }
        code: Theme.icon.next
        opacity: explained.locked ? 0 : 1
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    Hatch {
        visible: card.scrap
        anchors.fill: number
        color: Theme.color.warning
    }
    Readout {
        id: number
        ink: card.scrap ? Theme.color.warning : Theme.color.ink
        anchors { left: parent.left; top: parent.top; right: figures.left; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        title: card.scrap ? qsTr("Scrap bag") : qsTr("Bag length")
        titleColor: !Controller.fresh ? Theme.color.disabledInk : card.scrap ? Theme.color.warning : Theme.color.secondaryInk
        text: Theme.amount(Controller.bags.lengthMm, 1, "mm")
        unit: Theme.shownUnit("mm")
        stale: !Controller.fresh
    }
    Column {
        id: figures
        anchors { right: parent.right; rightMargin: Theme.size.padding; bottom: number.bottom; bottomMargin: Theme.size.spacing }
        Label {
            anchors.right: parent.right
            text: qsTr("mean %1").arg(Theme.amount(Controller.bags.meanMm, 2, "mm"))
            color: card.figureColor
            font.pixelSize: Theme.size.caption
        }
        Label {
            anchors.right: parent.right
            text: qsTr("std dev %1").arg(Theme.amount(Controller.bags.scatterMm, 2, "mm"))
            color: card.figureColor
            font.pixelSize: Theme.size.caption
        }
    }
    BagChart {
        id: chart
        objectName: "bagChart"
        visible: card.measured
        anchors { left: parent.left; right: parent.right; top: number.bottom; bottom: foot.top; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; bottomMargin: Theme.size.accent }
        values: Controller.bags.series
        tolerance: Controller.bags.toleranceMm
        stale: !Controller.fresh
        backgroundColor: Theme.color.inset
        gridColor: Theme.color.target
        pointColor: Theme.color.touch
        staleColor: Theme.color.target
        toleranceColor: Theme.color.secondaryInk
        violationColor: Theme.color.fault
        pointSize: Theme.size.accent + Theme.size.hairline
    }
    Label {
        anchors.centerIn: chart
        visible: !card.measured
        width: chart.width - 2 * Theme.size.padding
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Controller.run.bags
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: foot
        objectName: "toleranceText"
        anchors { left: parent.left; leftMargin: Theme.size.padding; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        width: Math.min(implicitWidth, chart.width / 2)
        fontSizeMode: Text.HorizontalFit
        text: qsTr("tolerance ±%1").arg(Theme.measure(Controller.bags.toleranceMm, 2, "mm"))
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        anchors { right: chart.right; verticalCenter: foot.verticalCenter }
        visible: card.measured
        width: Math.min(implicitWidth, chart.width / 2 - Theme.size.accent)
        fontSizeMode: Text.HorizontalFit
        text: qsTr("last %1").arg(Theme.signedAmount(Controller.bags.deviationMm, 2, "mm"))
        color: card.figureColor
        font.pixelSize: Theme.size.caption
    }
    Explained {
        id: explained
        objectName: "bagNumbers"
        field: "bag_length_mm"
        quantities: [Explanations.BagMean, Explanations.BagScatter, Explanations.BagDeviation]
    }
}
