// SPDX-License-Identifier: Apache-2.0
// The choice of the quantities drawn.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property var chosen: Trends.chosen
    readonly property TrendWords words: TrendWords {}

    readonly property int rows: Math.ceil(words.titles.length / 2)
    readonly property real head: Theme.size.touch + Theme.size.outline + Theme.size.padding
    readonly property real rowHeight: Math.min(Theme.size.touch * 1.2, (height - 2 * Theme.size.gap - head) / rows - Theme.size.spacing)

    panelHeight: sheet.head + sheet.rows * (sheet.rowHeight + Theme.size.spacing)
    title: qsTr("Curves")
    note: qsTr("Up to three curves; one more replaces the lowest.")

    Grid {
        id: grid
        anchors { left: parent.left; right: parent.right; top: parent.top }
        columns: 2
        spacing: Theme.size.spacing
        Repeater {
            model: sheet.words.titles.length
            ChoiceRow {
                required property int index
                objectName: "curve" + index
                width: (grid.width - grid.spacing) / 2
                height: sheet.rowHeight
                text: sheet.words.titles[index]
                note: sheet.words.notes[index]
                holds: sheet.chosen.includes(index)
                onClicked: Trends.toggle(index)
            }
        }
    }
}
