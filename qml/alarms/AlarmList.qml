// SPDX-License-Identifier: Apache-2.0
// A list of alarm occurrences; a sentence when it is empty.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: panel

    required property RowModel rows        // with the roles of AlarmRow
    required property string emptyText
    property string emptyGlyph
    property string listName               // name for tests
    signal opened(int row)

    ListView {
        id: list
        objectName: panel.listName
        anchors.fill: parent
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: panel.rows
        delegate: AlarmRow {
            required property int index
            objectName: panel.listName + index
            onClicked: panel.opened(index)
        }
    }
    ScrollMark { view: list }
    Column {
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: Theme.size.padding }
        visible: list.count === 0
        spacing: Theme.size.spacing
        IconLabel {
            width: parent.width
            visible: panel.emptyGlyph.length > 0
            code: panel.emptyGlyph
            color: Theme.color.good
            font.pixelSize: Theme.size.largeIcon
        }
        Label {
            objectName: "alarmsEmpty"
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.WordWrap
            text: panel.emptyText
            color: Theme.color.secondaryInk
        }
    }
}
