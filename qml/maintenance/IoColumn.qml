// SPDX-License-Identifier: Apache-2.0
// One column of the controller's inputs and outputs: lamp, name and value. A lit lamp is full, an unlit one is a ring.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Column {
    id: column

    required property string title
    required property IoList io
    required property int side             // Io.Input ...
    property bool withValues: true

    readonly property int rowHeight: Math.round(Theme.size.caption * 1.7)

    Label {
        width: parent.width
        height: Math.max(column.rowHeight, implicitHeight)
        wrapMode: Text.WordWrap
        text: column.title
        color: Theme.color.secondaryInk
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    Repeater {
        model: column.io.rows
        Item {
            id: row
            required property string name
            required property string value
            required property int side
            required property int lamp
            readonly property bool bad: lamp === Io.Bad
            readonly property color ink: column.io.stale ? Theme.color.disabledInk : bad ? Theme.color.fault : Theme.color.ink
            visible: side === column.side
            width: column.width
            height: column.rowHeight
            Rectangle {
                id: light
                anchors.verticalCenter: parent.verticalCenter
                visible: row.lamp !== Io.None
                width: Theme.size.mark
                height: width
                radius: width / 2
                color: row.lamp === Io.Off ? "transparent" : column.io.stale ? Theme.color.disabledInk : row.bad ? Theme.color.fault : Theme.color.touch
                border { width: Theme.size.outline; color: row.lamp === Io.Off || column.io.stale ? Theme.color.disabledInk : row.bad ? Theme.color.fault : Theme.color.touch }
            }
            Label {
                anchors { left: parent.left; leftMargin: Theme.size.mark + Theme.size.spacing; right: amount.left; rightMargin: column.withValues ? Theme.size.spacing : 0 }
                height: parent.height
                text: row.name
                fontSizeMode: Text.HorizontalFit
                minimumPixelSize: Theme.size.caption - 3
                color: row.ink
                font { pixelSize: Theme.size.caption; weight: row.bad ? Font.Bold : Font.Normal }
            }
            Label {
                id: amount
                anchors.right: parent.right
                height: parent.height
                text: row.value
                color: row.ink
                font { pixelSize: Theme.size.caption; weight: Font.Bold }
            }
        }
    }
}
