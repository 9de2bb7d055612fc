// SPDX-License-Identifier: Apache-2.0
// One law: its name, its figures in columns, and its strength and weakness below. The header row has the column titles.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Plot

TouchButton {
    id: row
    Accessible.role: row.header ? Accessible.StaticText : Accessible.Button
    Accessible.name: row.header ? row.headings.join(", ") : row.text

    property var shape: []                 // the picture of the law
    property list<string> notes            // strength, weakness
    property bool holds
    property bool header
    property bool marked                   // drawn in gray in the background
    property bool usable: true             // exceeds no limit
    required property list<string> cells
    readonly property var headings: cells

    readonly property real cellWidth: words.width * (cells.length > 5 ? 0.115 : cells.length > 4 ? 0.13 : 0.15)
    implicitHeight: Math.max(Theme.size.touch, words.height + Theme.size.padding)
    enabled: !header

    background: Rectangle {
        visible: !row.header
        radius: Theme.size.radius
        color: row.holds || row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: row.holds || row.marked ? Theme.size.outline : Theme.size.hairline; color: row.holds ? Theme.color.touch : row.marked ? Theme.color.target : Theme.color.line }
    }
    CurveThumbnail {
        id: drawing
        x: Theme.size.spacing
        y: Math.round((parent.height - height) / 2)
        visible: !row.header
        width: Math.round(1.2 * Theme.size.touch)
        height: Math.round(0.8 * Theme.size.touch)
        points: row.shape
        color: row.holds ? Theme.color.touch : Theme.color.secondaryInk
        lineWidth: Theme.size.curve
    }
    Column {
        id: words
        anchors { left: drawing.right; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        spacing: Theme.size.outline

        Row {
            width: parent.width
            Label {
                width: parent.width - row.cells.length * row.cellWidth
                text: row.text
                fontSizeMode: Text.HorizontalFit
                color: row.usable ? Theme.color.ink : Theme.color.secondaryInk
                font.weight: Font.DemiBold
            }
            Repeater {
                model: row.cells
                Label {
                    required property string modelData
                    anchors.verticalCenter: parent?.verticalCenter
                    width: row.cellWidth
                    leftPadding: Theme.size.spacing
                    rightPadding: Theme.size.accent
                    horizontalAlignment: Text.AlignRight
                    fontSizeMode: Text.HorizontalFit
                    wrapMode: Text.WordWrap
                    text: modelData
                    color: row.header ? Theme.color.secondaryInk : row.usable ? Theme.color.ink : Theme.color.secondaryInk
                    font { pixelSize: Theme.size.caption; weight: row.header ? Font.Normal : Font.DemiBold }
                }
            }
        }
        Label {
            visible: !row.usable
            width: parent.width
            wrapMode: Text.WordWrap
            text: row.holds ? qsTr("This law exceeds a limit with this recipe.") : qsTr("This law exceeds a limit with this recipe. Hold the law to compare.")
            color: row.holds || row.down ? Theme.color.ink : Theme.color.fault
            font.pixelSize: Theme.size.caption
        }
        Repeater {
            model: row.notes
            Row {
                id: sentence
                required property string modelData
                required property int index
                width: words.width
                Label {
                    id: sign
                    width: Theme.size.caption
                    text: sentence.index === 0 ? "+" : "\u2212"
                    color: Theme.color.secondaryInk
                    font { pixelSize: Theme.size.caption; bold: true }
                }
                Label {
                    width: parent.width - sign.width
                    wrapMode: Text.WordWrap
                    text: sentence.modelData
                    color: Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
        }
    }
}
