// SPDX-License-Identifier: Apache-2.0
// The last bag's length in digits for three metres, and beside it the last sixty as points on the scale of the tolerance. A tap
// changes the length, a held finger explains the numbers.
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
    readonly property bool special: card.scrap || Controller.bags.lengths > 1
    readonly property color noteColor: Controller.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk

    Hatch {
        objectName: "scrapHatch"
        visible: card.scrap
        anchors.fill: number
        color: Theme.color.warning
    }
    Label {
        id: title
        objectName: "lengthTitle"
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: chart.left; top: parent.top; topMargin: Theme.size.accent }
        fontSizeMode: Text.HorizontalFit
        text: card.scrap ? qsTr("Scrap bag, %1").arg(Theme.shownUnit("mm")) : Controller.bags.lengths > 1 ? qsTr("Bag of %1 lengths, skipped cut").arg(Controller.bags.lengths) : qsTr("Bag length, %1").arg(Theme.shownUnit("mm"))
        color: Controller.fresh && card.special ? Theme.color.warning : card.noteColor
        font.pixelSize: Theme.size.caption
    }
    DistantNumber {
        id: number
        objectName: "bagLength"
        anchors { left: title.left; top: title.bottom; topMargin: Theme.size.spacing; bottom: foot.top; bottomMargin: Theme.size.spacing }
        width: Math.min(naturalWidth, Math.round(0.8 * card.width) - 2 * Theme.size.padding)
        title: card.scrap ? qsTr("Scrap bag") : qsTr("Bag length")
        text: Theme.amount(Controller.bags.lengthMm, 1, "mm")
        unit: Theme.shownUnit("mm")
        ink: card.scrap ? Theme.color.warning : Theme.color.ink
        stale: !Controller.fresh
    }
    Label {
        id: foot
        objectName: "bagsWithin"
        anchors { left: title.left; right: last.left; rightMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: Theme.size.accent }
        fontSizeMode: Text.HorizontalFit
        text: !card.measured ? "" : Controller.bags.scrap === 0 ? Theme.fill(qsTr("%1 of %2 within"), [Controller.bags.within, Controller.bags.counted])
            : Theme.fill(qsTr("%1 of %2 within, scrap: %3"), [Controller.bags.within, Controller.bags.counted, Controller.bags.scrap])
        color: Controller.fresh && Controller.bags.within < Controller.bags.counted ? Theme.color.fault : card.noteColor
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: last
        objectName: "lastDeviation"
        visible: card.measured
        anchors { right: chart.right; verticalCenter: foot.verticalCenter }
        text: Theme.signedAmount(Controller.bags.deviationMm, 2, "mm")
        color: card.noteColor
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    Label {
        objectName: "toleranceText"
        anchors { right: arrow.left; rightMargin: Theme.size.accent; left: chart.left; verticalCenter: title.verticalCenter }
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: "±" + Theme.measure(Controller.bags.toleranceMm, 2, "mm")
        color: card.noteColor
        font.pixelSize: Theme.size.caption
    }
    IconLabel {
        id: arrow
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        code: Theme.icon.next
        opacity: explained.locked ? 0 : 1
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    BagChart {
        id: chart
        objectName: "bagChart"
        anchors { left: number.right; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; top: title.bottom; topMargin: Theme.size.accent; bottom: foot.top; bottomMargin: Theme.size.accent }
        opacity: card.measured ? 1 : 0
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
        anchors { left: title.left; right: parent.right; rightMargin: Theme.size.padding; verticalCenter: foot.verticalCenter }
        visible: !card.measured
        fontSizeMode: Text.HorizontalFit
        text: Controller.run.bags
        color: card.noteColor
        font.pixelSize: Theme.size.caption
    }
    Explained {
        id: explained
        objectName: "bagNumbers"
        field: "bag_length_mm"
        quantities: [Explanations.BagMean, Explanations.BagScatter, Explanations.BagsWithin, Explanations.BagDeviation]
    }
}
