// SPDX-License-Identifier: Apache-2.0
// The last bag's length in large digits, and beside it the last sixty as points in the tolerance band with their mean and
// scatter.
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

    Item {
        id: last
        width: Math.round((card.width - 3 * Theme.size.padding) * 0.46)
        anchors { left: parent.left; leftMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        IconLabel {
            id: arrow
            anchors { right: parent.right; top: parent.top }
            code: Theme.icon.next
            opacity: explained.locked ? 0 : 1
            color: Theme.color.touch
            font.pixelSize: Theme.size.body
        }
        Hatch {
            objectName: "scrapHatch"
            visible: card.scrap
            anchors { fill: number; rightMargin: arrow.width }
            color: Theme.color.warning
        }
        Readout {
            id: number
            objectName: "bagLength"
            ink: card.scrap ? Theme.color.warning : Theme.color.ink
            anchors { left: parent.left; right: parent.right; top: parent.top; bottom: bagFigures.top }
            title: card.scrap ? qsTr("Scrap bag") : Controller.bags.lengths > 1 ? qsTr("Bag of %1 lengths, skipped cut").arg(Controller.bags.lengths) : qsTr("Bag length")
            titleColor: !Controller.fresh ? Theme.color.disabledInk : card.scrap || Controller.bags.lengths > 1 ? Theme.color.warning : Theme.color.secondaryInk
            titleInset: arrow.width
            text: Theme.amount(Controller.bags.lengthMm, 1, "mm")
            unit: Theme.shownUnit("mm")
            stale: !Controller.fresh
        }
        Label {
            id: bagFigures
            objectName: "bagFigures"
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            fontSizeMode: Text.HorizontalFit
            text: Theme.fill(qsTr("mean %1, std dev %2"), [Theme.amount(Controller.bags.meanMm, 2, "mm"), Theme.amount(Controller.bags.scatterMm, 2, "mm")])
            color: card.figureColor
            font.pixelSize: Theme.size.caption
        }
    }
    BagChart {
        id: chart
        objectName: "bagChart"
        visible: card.measured
        anchors { left: last.right; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.padding; bottom: foot.top; bottomMargin: Theme.size.accent }
        values: Controller.bags.series
        mean: Controller.bags.meanDeviationMm
        scatter: Controller.bags.scatterMm
        tolerance: Controller.bags.toleranceMm
        stale: !Controller.fresh
        backgroundColor: Theme.color.inset
        gridColor: Theme.color.target
        pointColor: Theme.color.touch
        staleColor: Theme.color.target
        toleranceColor: Theme.color.secondaryInk
        violationColor: Theme.color.fault
        pointSize: Theme.size.accent
    }
    Label {
        objectName: "bagsText"
        anchors.centerIn: chart
        visible: !card.measured
        width: chart.width
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Controller.run.bags
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: foot
        objectName: "toleranceText"
        anchors { left: chart.left; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        width: chart.width * 0.5 - Theme.size.accent
        fontSizeMode: Text.HorizontalFit
        text: "±" + Theme.measure(Controller.bags.toleranceMm, 2, "mm")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        objectName: "bagsWithin"
        visible: card.measured
        anchors { right: chart.right; verticalCenter: foot.verticalCenter }
        width: chart.width * 0.5
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: Controller.bags.scrap === 0 ? Theme.fill(qsTr("%1 of %2 within"), [Controller.bags.within, Controller.bags.counted])
            : Theme.fill(qsTr("%1 of %2 within, scrap: %3"), [Controller.bags.within, Controller.bags.counted, Controller.bags.scrap])
        color: !Controller.fresh ? Theme.color.disabledInk : Controller.bags.within < Controller.bags.counted ? Theme.color.fault : Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Explained {
        id: explained
        objectName: "bagNumbers"
        field: "bag_length_mm"
        quantities: [Explanations.BagMean, Explanations.BagScatter, Explanations.BagsWithin, Explanations.BagDeviation]
    }
}
