// SPDX-License-Identifier: Apache-2.0
// Stops: a shift as a bar of states, the reasons of its stops by their time, and its effectiveness.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    readonly property bool known: Stops.shift.content === ShiftView.Shown

    Binding {
        target: Stops.shift
        property: "watched"
        value: page.visible && !Display.dark
    }
    Connections {
        target: Stops.shift.csv
        function onReady() { Frame.open("Parts/ReportFilesSheet", { title: qsTr("Stops as CSV") }) }
    }
    Row {
        id: head
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        Button {
            id: previous
            objectName: "shiftPrevious"
            Accessible.name: qsTr("Previous shift")
            glyph: Theme.icon.previous
            onClicked: Stops.shift.showPrevious()
        }
        Card {
            width: head.width - previous.width - next.width - now.width - trends.width - 4 * head.spacing
            height: previous.height
            Column {
                anchors { left: parent.left; right: parent.right; margins: Theme.size.spacing; verticalCenter: parent.verticalCenter }
                Label {
                    objectName: "shiftTitle"
                    width: parent.width
                    horizontalAlignment: Text.AlignHCenter
                    fontSizeMode: Text.HorizontalFit
                    text: Stops.shift.title
                    font { pixelSize: Theme.size.title; weight: Font.DemiBold }
                }
                Label {
                    objectName: "shiftNote"
                    visible: text.length > 0
                    width: parent.width
                    horizontalAlignment: Text.AlignHCenter
                    fontSizeMode: Text.HorizontalFit
                    text: Stops.shift.note
                    color: Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
        }
        Button {
            id: next
            objectName: "shiftNext"
            Accessible.name: qsTr("Next shift")
            glyph: Theme.icon.next
            enabled: !Stops.shift.isPresent
            onClicked: Stops.shift.showNext()
        }
        Button {
            id: now
            objectName: "shiftNow"
            text: qsTr("Now")
            enabled: !Stops.shift.isPresent
            onClicked: Stops.shift.showPresent()
        }
        Button {
            id: trends
            objectName: "shiftTrends"
            glyph: Theme.icon.trends
            text: qsTr("Trends")
            onClicked: Frame.openPage("trends")
        }
    }
    StateBar {
        id: bar
        anchors { left: parent.left; right: parent.right; top: head.bottom; topMargin: Theme.size.spacing }
        height: Math.round((actions.y - y) * 0.34)
    }
    ReasonList {
        anchors { left: parent.left; right: figures.left; rightMargin: Theme.size.spacing; top: figures.top; bottom: figures.bottom }
    }
    OeeCard {
        id: figures
        anchors { right: parent.right; top: bar.bottom; topMargin: Theme.size.spacing; bottom: actions.top; bottomMargin: Theme.size.spacing }
        width: Math.round(parent.width * 0.42)
    }
    Row {
        id: actions
        anchors { left: parent.left; bottom: parent.bottom; bottomMargin: page.bottomInset }
        spacing: Theme.size.spacing
        Button {
            objectName: "shiftStops"
            kind: Stops.shift.openStops > 0 ? Button.Primary : Button.Normal
            enabled: page.known
            text: qsTr("Stops: %1").arg(Stops.shift.stops.count)
            note: Stops.shift.openStops > 0 ? qsTr("%1 without a reason").arg(Stops.shift.openStops) : ""
            onClicked: Frame.open("Stops/StopListSheet", {})
        }
        Button {
            objectName: "shiftCsv"
            level: Access.Operator
            glyph: Theme.icon.save
            text: qsTr("CSV")
            enabled: page.known && !Stops.shift.csv.busy
            onClicked: if (Access.ask(Access.Operator)) Stops.shift.csv.make(Maintenance.files)
        }
        Button {
            objectName: "shiftPdf"
            level: Access.Operator
            glyph: Theme.icon.save
            text: qsTr("PDF")
            enabled: page.known
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                ShiftReport.offer()
                Frame.open("Parts/ReportFilesSheet", { title: qsTr("Shift report as PDF") })
            }
        }
    }
    Label {
        objectName: "shiftTimes"
        anchors { left: actions.right; right: parent.right; top: actions.top; bottom: actions.bottom; leftMargin: Theme.size.padding }
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Stops.shift.content === ShiftView.Nothing ? qsTr("Nothing was recorded in this shift.") : Stops.shift.timesText
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
