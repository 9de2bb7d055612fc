// SPDX-License-Identifier: Apache-2.0
// One row of a table of numbers, right-aligned; the second column is text.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: row

    required property list<string> cells
    property bool header
    property bool shaded

    implicitHeight: Math.round(Theme.size.body * 1.9)
    color: shaded ? Theme.color.inset : Theme.color.surface

    Row {
        anchors.fill: parent
        Repeater {
            model: row.cells
            Label {
                required property string modelData
                required property int index
                width: (row.width - Theme.size.padding) / row.cells.length
                height: row.height
                leftPadding: index === 1 ? Theme.size.padding : 0
                horizontalAlignment: index === 1 ? Text.AlignLeft : Text.AlignRight
                fontSizeMode: Text.HorizontalFit
                text: modelData
                color: row.header ? Theme.color.secondaryInk : Theme.color.ink
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
