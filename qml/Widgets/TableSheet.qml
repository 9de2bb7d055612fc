// SPDX-License-Identifier: Apache-2.0
// The step table that the controller will execute, with its own error figures.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Machine

Sheet {
    id: sheet

    title: qsTr("Step table")

    readonly property var figures: Editor.tableSummary

    Label {
        id: summary
        anchors { left: parent.left; right: parent.right; top: parent.top }
        wrapMode: Text.WordWrap
        text: sheet.figures.join("  ·  ")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    TableRow {
        id: head
        anchors { left: parent.left; right: parent.right; top: summary.bottom; topMargin: Theme.size.spacing }
        header: true
        cells: [qsTr("Row"), qsTr("Stretch"), qsTr("Time ms"), qsTr("Frequency Hz"), qsTr("Pulses"), qsTr("Timer ticks")]
    }
    ListView {
        id: list
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: parent.bottom }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.table
        delegate: TableRow {
            required property int row
            required property string segment
            required property string timeText
            required property string frequencyText
            required property string pulsesText
            required property string ticksText
            width: list.width
            shaded: row % 2 === 1
            cells: [row, segment, timeText, frequencyText, pulsesText, ticksText]
        }
    }
    ScrollMark { view: list }
    Label {
        anchors.fill: list
        visible: list.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Editor.verdict
        color: Theme.color.secondaryInk
    }
}
