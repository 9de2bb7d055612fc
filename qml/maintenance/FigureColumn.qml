// SPDX-License-Identifier: Apache-2.0
// A heading with named figures below; unusual ones stand out. A held finger requests their explanation.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: column

    required property string title
    required property RowModel figures
    property var quantities: []            // computed ones, of Explanations; empty: no explanation

    readonly property int rowHeight: Math.round(Theme.size.caption * 1.5)

    implicitHeight: rows.height

    Column {
        id: rows
        width: parent.width
        Label {
            width: parent.width
            height: column.rowHeight
            text: column.title
            color: Theme.color.secondaryInk
            font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
        }
        Repeater {
            model: column.figures
            Item {
                id: figure
                required property string label
                required property string value
                required property bool notable
                width: rows.width
                height: column.rowHeight
                Label {
                    width: parent.width - amount.width - Theme.size.spacing
                    height: parent.height
                    text: figure.label
                    fontSizeMode: Text.HorizontalFit
                    font.pixelSize: Theme.size.caption
                }
                Label {
                    id: amount
                    anchors.right: parent.right
                    height: parent.height
                    text: figure.value
                    color: figure.notable ? Theme.color.warning : Theme.color.ink
                    font { pixelSize: Theme.size.caption; weight: Font.Bold }
                }
            }
        }
    }
    Explained {
        Accessible.name: column.title
        enabled: column.quantities.length > 0
        quantities: column.quantities
    }
}
