// SPDX-License-Identifier: Apache-2.0
// The statistics of the line, as figures and as a chart of 24 hours.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

MaintenanceSection {
    id: section

    readonly property LineFigures figures: Maintenance.figures

    onShownChanged: shown => section.figures.watched = shown

    Row {
        id: columns
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.padding * 2
        readonly property real columnWidth: (width - 2 * spacing) / 3
        FigureColumn {
            width: columns.columnWidth
            objectName: "figuresExchanges"
            title: qsTr("Communication")
            figures: section.figures.exchanges
            quantities: [Explanations.WireShare]
        }
        FigureColumn {
            width: columns.columnWidth
            title: qsTr("Errors")
            figures: section.figures.errors
        }
        FigureColumn {
            width: columns.columnWidth
            objectName: "figuresTimes"
            title: qsTr("Response time")
            figures: section.figures.times
            quantities: [Explanations.AnswersHalf, Explanations.Answers95, Explanations.Answers99, Explanations.AnswersLongest, Explanations.AnswerAllowance]
        }
    }
    Flow {
        id: counted
        anchors { left: parent.left; right: parent.right; top: columns.bottom }
        spacing: Theme.size.padding * 2
        Label {
            text: qsTr("Controller:")
            color: Theme.color.secondaryInk
            font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
        }
        Repeater {
            model: section.figures.controller
            Row {
                id: pair
                required property string label
                required property string value
                required property bool notable
                spacing: Theme.size.spacing
                Label {
                    text: pair.label
                    font.pixelSize: Theme.size.caption
                }
                Label {
                    text: pair.value
                    color: pair.notable ? Theme.color.warning : Theme.color.ink
                    font { pixelSize: Theme.size.caption; weight: Font.Bold }
                }
            }
        }
    }
    StripChart {
        objectName: "stripChart"
        anchors { left: parent.left; right: foot.left; rightMargin: Theme.size.padding; top: counted.bottom; bottom: parent.bottom; topMargin: Theme.size.spacing }
        answers: section.figures.stripAnswers
        errors: section.figures.stripErrors
        timesMs: section.figures.stripP99Ms
        end: section.figures.stripEnd
        answersTitle: qsTr("Responses, max. %1 per minute")
        timesTitle: qsTr("99 % of responses within, max. %1 ms")
        errorsTitle: qsTr("Errors, max. %1 per minute")
        localeName: Theme.language
        textFont: Theme.captionFont
        textColor: Theme.color.secondaryInk
        backgroundColor: Theme.color.surface
        gridColor: Theme.color.line
        answersColor: Theme.color.touch
        timesColor: Theme.color.position
        errorsColor: Theme.color.fault
    }
    Column {
        id: foot
        readonly property real keyWidth: Math.max(resetButton.implicitWidth, exportButton.implicitWidth)
        anchors { right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.spacing
        Button {
            id: resetButton
            objectName: "figuresReset"
            level: Access.Operator
            width: foot.keyWidth
            glyph: Theme.icon.refresh
            text: qsTr("Reset counters")
            onClicked: section.figures.reset()
        }
        Button {
            id: exportButton
            objectName: "figuresExport"
            level: Access.Operator
            width: foot.keyWidth
            glyph: Theme.icon.save
            text: qsTr("Export CSV")
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                section.figures.exportCsv()
                Frame.open("Parts/ReportFilesSheet", { title: qsTr("Statistics as CSV") })
            }
        }
    }
}
