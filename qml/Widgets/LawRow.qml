// SPDX-License-Identifier: Apache-2.0
// One law: name and character at the left, its four peaks in columns. As the header it shows the column titles.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme
import CamPanel.Controls

T.AbstractButton {
    id: row

    property string note
    property bool holds
    property bool header
    property bool marked                   // drawn in grey behind
    required property list<string> cells

    readonly property real cellWidth: width * 0.135
    implicitHeight: Math.max(Theme.size.touch, words.height + Theme.size.padding)
    enabled: !header

    background: Rectangle {
        visible: !row.header
        radius: Theme.size.radius
        color: row.holds || row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: row.holds || row.marked ? Theme.size.outline : Theme.size.hairline; color: row.holds ? Theme.color.touch : row.marked ? Theme.color.target : Theme.color.line }
    }
    Column {
        id: words
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
        width: row.width - 4 * row.cellWidth - 2 * Theme.size.padding
        Label {
            width: parent.width
            visible: !row.header
            text: row.text
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.caption
            color: row.enabled ? Theme.color.ink : Theme.color.disabledInk
            font.weight: Font.DemiBold
        }
        Label {
            width: parent.width
            visible: row.note.length > 0
            wrapMode: Text.WordWrap
            text: row.note
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Row {
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        Repeater {
            model: row.cells
            Label {
                required property string modelData
                width: row.cellWidth - Theme.size.spacing
                rightPadding: Theme.size.accent
                horizontalAlignment: Text.AlignRight
                fontSizeMode: Text.HorizontalFit
                minimumPixelSize: Theme.size.caption - 3
                text: modelData
                color: row.header ? Theme.color.secondaryInk : row.enabled ? Theme.color.ink : Theme.color.disabledInk
                font { pixelSize: Theme.size.caption; weight: row.header ? Font.Normal : Font.DemiBold }
            }
        }
    }
}
