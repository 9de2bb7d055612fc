// SPDX-License-Identifier: Apache-2.0
// A small card of Run with a title: what a tap opens stands behind it, and a held finger explains its numbers.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts

Card {
    id: tile

    required property string title
    property color titleColor: Theme.color.secondaryInk
    property var quantities: []
    default property alias content: column.data
    signal clicked()

    Label {
        id: caption
        objectName: "tileTitle"
        anchors { left: parent.left; right: arrow.left; top: parent.top; leftMargin: Theme.size.padding; topMargin: Theme.size.accent }
        fontSizeMode: Text.HorizontalFit
        text: tile.title
        color: tile.titleColor
        font.pixelSize: Theme.size.caption
    }
    IconLabel {
        id: arrow
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        code: Theme.icon.next
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    Column {
        id: column
        anchors { left: parent.left; right: parent.right; top: caption.bottom; bottom: parent.bottom; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.outline; bottomMargin: Theme.size.accent }
    }
    Explained {
        objectName: tile.objectName + "Touch"
        Accessible.name: tile.title
        quantities: tile.quantities
        onTapped: tile.clicked()
    }
}
