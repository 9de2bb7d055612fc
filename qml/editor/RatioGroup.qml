// SPDX-License-Identifier: Apache-2.0
// The four ratios in one touch target, with their origin above; a tap is near one of them.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

TouchButton {
    id: group
    Accessible.name: group.fields.map(field => field.label).join(", ")

    required property var fields           // list of EditorField
    property string caption                // the origin of the ratios
    readonly property int nearest: Math.max(0, Math.min(3, Math.floor(4 * group.pressX / group.width))) // to the finger

    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: group.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.line }
    }
    Label {
        id: origin
        objectName: "ratioOrigin"
        visible: text.length > 0
        anchors { left: parent.left; right: arrow.left; top: parent.top; margins: Theme.size.spacing; leftMargin: Theme.size.padding }
        text: group.caption
        fontSizeMode: Text.HorizontalFit
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    IconLabel {
        id: arrow
        visible: origin.visible
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: origin.verticalCenter }
        code: Theme.icon.next
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    Row {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; top: origin.visible ? origin.bottom : parent.top }
        Repeater {
            model: group.fields.length
            Item {
                id: cell
                required property int index
                readonly property EditorField field: group.fields[index]
                width: group.width / group.fields.length
                height: parent.height
                Rectangle {
                    visible: cell.index > 0
                    width: Theme.size.hairline
                    height: parent.height - 2 * Theme.size.spacing
                    anchors.verticalCenter: parent.verticalCenter
                    color: Theme.color.line
                }
                Column {
                    anchors.centerIn: parent
                    Label {
                        anchors.horizontalCenter: parent.horizontalCenter
                        text: cell.field.fieldId
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                    Label {
                        anchors.horizontalCenter: parent.horizontalCenter
                        width: Math.min(implicitWidth, cell.width - Theme.size.spacing)
                        fontSizeMode: Text.HorizontalFit
                        text: cell.field.text
                        color: group.locked ? Theme.color.secondaryInk : Theme.color.ink
                        font { pixelSize: Theme.size.body; bold: true }
                    }
                }
            }
        }
    }
}
