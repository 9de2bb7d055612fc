// SPDX-License-Identifier: Apache-2.0
// The curves of the chosen quantities, each with its name and its figures above: for the window, or at the cursor, away from
// the finger.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

Card {
    id: card

    property real cursor: NaN
    property int revision
    readonly property real toleranceMm: Settings.setting("bags.tolerance_mm").key
    readonly property bool empty: Trends.content !== Trends.Shown
    readonly property TrendWords words: TrendWords {}

    function momentOf(timeMs: real): string { return plot.momentText(timeMs) }
    function figure(quantity: int, value: real): string {
        return Theme.amount(value, card.words.decimals[quantity], card.words.metricUnits[quantity])
    }
    function figuresOf(lane: int, quantity: int): string {
        const found = Trends.statistics[lane]
        if (!found || found.count === 0)
            return qsTr("no data in this time")
        const form = quantity <= Trends.Deviation ? qsTr("n %1 · mean %2 · std dev %3 · %4 … %5 · %6 % within") : qsTr("n %1 · mean %2 · std dev %3 · %4 … %5")
        return Theme.fill(form, [Theme.count(found.count, 0), card.figure(quantity, found.mean), card.figure(quantity, found.scatter),
                                 card.figure(quantity, found.low), card.figure(quantity, found.high), Theme.number(100 * found.within, 1)])
    }
    function explain(lane: int): void {
        const explanations = isNaN(card.cursor) ? Explanations.ofTrend(lane) : Explanations.ofTrendCursor(lane, plot.valuesAt(lane, card.cursor))
        if (explanations.length > 0)
            Frame.open("Explain/NumbersSheet", { heading: card.words.titles[Trends.chosen[lane]], told: explanations })
    }
    // Returns the figures; `at` is the revision of the curves that a binding depends on.
    function valuesOf(lane: int, quantity: int, at: int): string {
        const values = plot.valuesAt(lane, card.cursor)
        return isNaN(values[1]) ? qsTr("%1 · no data").arg(card.momentOf(card.cursor))
            : Theme.fill(qsTr("%1 · mean %2 · %3 … %4"), [card.momentOf(card.cursor), card.figure(quantity, values[1]), card.figure(quantity, values[0]), card.figure(quantity, values[2])])
    }

    TrendPlot {
        id: plot
        objectName: "trendPlot"
        Accessible.role: Accessible.Graphic
        Accessible.name: qsTr("Trend curves")
        visible: !card.empty
        anchors { fill: parent; margins: Theme.size.spacing }
        curves: Trends.curves
        lanes: Trends.chosen.length
        fromMs: Trends.fromMs
        toMs: Trends.toMs
        tolerances: Array.from(Trends.chosen, quantity => quantity === Trends.Deviation ? card.toleranceMm : NaN)
        factors: Array.from(Trends.chosen, quantity => Theme.unitFactor(card.words.metricUnits[quantity]))
        laneColors: Array.from(Trends.chosen, quantity => card.words.colors[quantity])
        cursorMs: card.cursor
        headerHeight: Theme.size.caption * 1.7
        headerReach: Theme.size.touch
        gridColor: Theme.color.line
        inkColor: Theme.color.ink
        secondaryInkColor: Theme.color.secondaryInk
        toleranceColor: Theme.color.secondaryInk
        lineWidth: Theme.size.curve
        axisFont: Theme.captionFont
        onWindowWanted: (fromMs, toMs) => Trends.showWindow(fromMs, toMs)
        onCursorWanted: timeMs => card.cursor = Math.abs(plot.xOfTime(timeMs) - plot.xOfTime(card.cursor)) < Theme.size.touch / 4 ? NaN : timeMs
        onLayoutChanged: ++card.revision
        onHeaderHeld: lane => card.explain(lane)

        Binding {
            target: plot
            property: "locale"
            value: Theme.locale
        }
        Repeater {
            model: Trends.chosen
            Item {
                id: header
                required property int index
                required property int modelData
                y: card.revision >= 0 ? plot.laneTop(header.index) : 0
                width: plot.width
                height: plot.headerHeight
                Label {
                    id: title
                    x: card.revision >= 0 ? plot.plotArea.x : 0
                    height: parent.height
                    text: card.words.titles[header.modelData]
                    color: card.words.colors[header.modelData]
                    font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
                }
                Label {
                    objectName: "trendFigures" + header.index
                    anchors { left: title.right; right: parent.right; leftMargin: Theme.size.padding; rightMargin: Theme.size.spacing }
                    height: parent.height
                    horizontalAlignment: Text.AlignRight
                    fontSizeMode: Text.HorizontalFit
                    text: isNaN(card.cursor) ? card.figuresOf(header.index, header.modelData) : card.valuesOf(header.index, header.modelData, card.revision)
                    color: isNaN(card.cursor) ? Theme.color.secondaryInk : Theme.color.ink
                    font { pixelSize: Theme.size.caption; weight: isNaN(card.cursor) ? Font.Normal : Font.DemiBold }
                }
            }
        }
    }
    Label {
        objectName: "trendEmpty"
        anchors.centerIn: parent
        visible: card.empty && Trends.content !== Trends.Unread
        width: parent.width - 4 * Theme.size.padding
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Trends.content === Trends.NothingYet ? Controller.run.trends
            : qsTr("There are no data in this time. Press Now, or − for a longer time.")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.title
    }
}
