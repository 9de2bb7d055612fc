// SPDX-License-Identifier: Apache-2.0
// One column of the controller's inputs and outputs: lamp, name and value, what a pin does, and of an output the key that
// tries it. A lit lamp is full, an unlit one is a ring.
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
    property OutputTry trying: null        // of a column with outputs

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
            required property string purpose
            required property int output
            readonly property bool bad: lamp === Io.Bad || lamp === Io.Warning
            readonly property color badColor: lamp === Io.Bad ? Theme.color.fault : Theme.color.warning
            readonly property color ink: column.io.stale ? Theme.color.disabledInk : bad ? badColor : Theme.color.ink
            visible: side === column.side
            width: column.width
            height: Math.max(texts.height, key.visible ? key.height + Theme.size.spacing : 0)
            Rectangle {
                id: light
                y: Math.round((column.rowHeight - height) / 2)
                visible: row.lamp !== Io.None
                width: Theme.size.mark
                height: width
                radius: width / 2
                color: row.lamp === Io.Off ? "transparent" : column.io.stale ? Theme.color.disabledInk : row.bad ? row.badColor : Theme.color.touch
                border { width: Theme.size.outline; color: row.lamp === Io.Off || column.io.stale ? Theme.color.disabledInk : row.bad ? row.badColor : Theme.color.touch }
            }
            Column {
                id: texts
                anchors { left: parent.left; leftMargin: Theme.size.mark + Theme.size.spacing; right: key.visible ? key.left : parent.right; rightMargin: key.visible ? Theme.size.spacing : 0 }
                Label {
                    width: parent.width - (column.withValues ? amount.width + Theme.size.spacing : 0)
                    height: Math.max(column.rowHeight, implicitHeight)
                    wrapMode: Text.WordWrap
                    text: row.name
                    color: row.ink
                    font { pixelSize: Theme.size.caption; weight: row.bad ? Font.Bold : Font.Normal }
                }
                Label {
                    visible: row.purpose.length > 0
                    width: parent.width
                    bottomPadding: Theme.size.spacing / 2
                    wrapMode: Text.WordWrap
                    text: row.purpose
                    color: column.io.stale ? Theme.color.disabledInk : Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption
                }
            }
            HoldKey {
                id: key
                objectName: "try" + row.output
                level: Access.Technician
                anchors.right: parent.right
                visible: row.output >= 0 && column.trying !== null && column.trying.offered
                trying: column.trying
                output: row.output
                name: row.name
            }
            Label {
                id: amount
                anchors.right: parent.right
                height: column.rowHeight
                text: row.value
                color: row.ink
                font { pixelSize: Theme.size.caption; weight: Font.Bold }
            }
        }
    }
}
