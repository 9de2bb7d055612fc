// SPDX-License-Identifier: Apache-2.0
// One law: its name, its figures in columns, and its strength and weakness below. The header row has the column titles.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Plot

ListRow {
    id: row
    Accessible.name: row.header ? row.headings.join(", ") : row.text

    property var shape: []                 // the picture of the law
    property list<string> notes            // strength, weakness
    property bool header
    property bool marked                   // drawn in gray in the background
    property bool usable: true             // exceeds no limit
    required property list<string> cells
    readonly property var headings: cells
    readonly property real cellWidth: firstLine.width * (cells.length > 5 ? 0.115 : cells.length > 4 ? 0.13 : 0.15)
    readonly property real wordsHeight: words.height

    enabled: !header
    tappable: !header
    mark: ""
    frame: header ? 0 : holds || marked ? Theme.size.outline : Theme.size.hairline
    frameColor: holds ? Theme.color.touch : marked ? Theme.color.target : Theme.color.line
    leftPadding: drawing.width
    rightRoom: cells.length * cellWidth
    firstLine.height: Math.max(titleLabel.height, figures.height)
    titleLabel.color: usable ? Theme.color.ink : Theme.color.secondaryInk
    note: Array.from(notes, (text, i) => (i === 0 ? "+ " : "\u2212 ") + text).join("\n")
    noteLabel { wrapMode: Text.WordWrap; fontSizeMode: Text.FixedSize }

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
    Row {
        id: figures
        parent: row.firstLine
        anchors { right: parent?.right; verticalCenter: parent?.verticalCenter }
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
                color: row.header ? Theme.color.secondaryInk : row.titleLabel.color
                font { pixelSize: Theme.size.caption; weight: row.header ? Font.Normal : Font.DemiBold }
            }
        }
    }
    Label {
        parent: row.words
        visible: !row.usable
        width: parent?.width ?? 0
        wrapMode: Text.WordWrap
        text: row.holds ? qsTr("This law exceeds a limit with this recipe.") : qsTr("This law exceeds a limit with this recipe. Hold the law to compare.")
        color: row.holds || row.down ? Theme.color.ink : Theme.color.fault
        font.pixelSize: Theme.size.caption
    }
}
