// SPDX-License-Identifier: Apache-2.0
// Trends: the course of bags, rate and line over minutes to days, with touch gestures for moving and zooming, and CSV
// export.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    readonly property var spans: [
        { key: 600000, name: "span10min", text: qsTr("10 min") },
        { key: 3600000, name: "span1h", text: qsTr("1 h") },
        { key: 28800000, name: "span8h", text: qsTr("8 h") },
        { key: 86400000, name: "span1d", text: qsTr("1 day") },
        { key: 604800000, name: "span7d", text: qsTr("7 days") }
    ]

    Binding {
        target: Trends
        property: "watched"
        value: page.visible
    }
    Connections {
        target: Trends.csv
        function onReady() { Frame.open("Parts/ReportFilesSheet", { title: qsTr("Bags and trends as CSV") }) }
    }
    Segmented {
        id: spanRow
        anchors { left: parent.left; right: stopsKey.left; top: parent.top; rightMargin: Theme.size.spacing }
        color: Theme.color.surface
        choices: page.spans
        current: Trends.spanMs
        onChosen: key => Trends.showSpan(key)
    }
    Button {
        id: stopsKey
        objectName: "trendStops"
        anchors { right: parent.right; top: parent.top }
        glyph: Theme.icon.pause
        text: qsTr("Stops")
        onClicked: Frame.openPage("stops")
    }
    TrendCard {
        id: card
        objectName: "trendCard"
        anchors { left: parent.left; right: parent.right; top: spanRow.bottom; bottom: actions.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
    }
    Row {
        id: actions
        anchors { left: parent.left; bottom: parent.bottom; bottomMargin: page.bottomInset }
        spacing: Theme.size.spacing
        Button {
            objectName: "trendCurves"
            glyph: Theme.icon.view
            text: qsTr("Curves")
            onClicked: Frame.open("Trends/TrendCurvesSheet", {})
        }
        Button {
            objectName: "trendExport"
            level: Access.Operator
            glyph: Theme.icon.save
            text: qsTr("CSV")
            enabled: Trends.content === Trends.Shown && !Trends.csv.busy
            onClicked: if (Access.ask(Access.Operator)) Trends.csv.make(Maintenance.files)
        }
    }
    Label {
        objectName: "trendRange"
        anchors { left: actions.right; right: zoomRow.left; top: actions.top; bottom: actions.bottom; leftMargin: Theme.size.spacing; rightMargin: Theme.size.spacing }
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        readonly property string range: Theme.fill(qsTr("%1 –\n%2", "from, to"), [card.momentOf(Trends.fromMs), card.momentOf(Trends.toMs)])
        fontSizeMode: Text.Fit
        text: Trends.clockDoubtful ? qsTr("%1\nclock not set", "from, to").arg(range) : range
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Row {
        id: zoomRow
        anchors { right: parent.right; top: actions.top }
        spacing: Theme.size.spacing
        Button {
            objectName: "trendLonger"
            text: "−"
            onClicked: Trends.zoom(2)
        }
        Button {
            objectName: "trendShorter"
            text: "+"
            onClicked: Trends.zoom(0.5)
        }
        Button {
            objectName: "trendNow"
            text: qsTr("Now")
            enabled: !Trends.live
            onClicked: Trends.showNow()
        }
    }
}
