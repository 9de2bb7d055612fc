// SPDX-License-Identifier: Apache-2.0
// A knot or segment in the list of its sheet: number and place, below what it does.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

TouchButton {
    id: entry

    required property int number
    required property string place
    required property string detail
    required property bool selected
    property bool warns

    width: ListView.view ? ListView.view.width - (ListView.view.visibleArea.heightRatio < 1 ? 2 * Theme.size.accent : 0) : 0
    height: Theme.size.touch
    background: Rectangle {
        radius: Theme.size.radius
        color: entry.selected || entry.down ? Theme.color.touchTint : Theme.color.surface
        border { width: entry.selected ? Theme.size.hairline : 0; color: Theme.color.touch }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors { left: parent.left; right: parent.right; margins: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            Item {
                width: parent.width
                height: place.height
                Label {
                    id: number
                    text: entry.number
                    font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
                }
                Label {
                    id: place
                    anchors { left: number.right; leftMargin: Theme.size.spacing; right: parent.right }
                    horizontalAlignment: Text.AlignRight
                    text: entry.place
                    fontSizeMode: Text.HorizontalFit
                    font.pixelSize: Theme.size.caption
                }
            }
            Label {
                width: parent.width
                horizontalAlignment: Text.AlignRight
                text: entry.detail
                fontSizeMode: Text.HorizontalFit
                wrapMode: Text.WordWrap    // below the smallest size
                maximumLineCount: 2
                lineHeight: lineCount > 1 ? 0.85 : 1
                color: entry.warns ? Theme.color.warning : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
}
