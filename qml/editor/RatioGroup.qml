// SPDX-License-Identifier: Apache-2.0
// The four ratios in one touch target; a tap opens the keypad for the nearest one.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

T.AbstractButton {
    id: group

    required property var fields           // list of EditorField
    signal editRequested(int index)

    implicitHeight: Theme.size.touch
    onClicked: group.editRequested(Math.max(0, Math.min(3, Math.floor(4 * group.pressX / group.width))))

    background: Rectangle {
        radius: Theme.size.radius
        color: group.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.line }
    }
    Row {
        anchors.fill: parent
        Repeater {
            model: group.fields.length
            Item {
                id: cell
                required property int index
                readonly property EditorField field: group.fields[index]
                width: group.width / group.fields.length
                height: group.height
                Rectangle {
                    visible: cell.index > 0
                    width: Theme.size.hairline
                    height: parent.height - 2 * Theme.size.padding
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
                        minimumPixelSize: Theme.size.caption
                        text: cell.field.text
                        font { pixelSize: Theme.size.body; bold: true }
                    }
                }
            }
        }
    }
}
