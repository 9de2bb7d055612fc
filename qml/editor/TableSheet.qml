// SPDX-License-Identifier: Apache-2.0
// The table that the controller will execute, with its own error figures.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    title: Editor.table.name

    readonly property var figures: Editor.table.summary
    readonly property var columns: Editor.table.columns

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
        cells: sheet.columns
    }
    ListView {
        id: list
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: parent.bottom }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.table
        delegate: TableRow {
            required property int index
            width: list.width
            shaded: index % 2 === 0
        }
    }
    ScrollMark { view: list }
    Label {
        anchors.fill: list
        visible: list.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Theme.unbroken(Editor.verdict)
        color: Theme.color.secondaryInk
    }
}
