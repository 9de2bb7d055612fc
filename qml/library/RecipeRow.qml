// SPDX-License-Identifier: Apache-2.0
// One recipe of the list: name, figures, time of the last save; open or active.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Plot

TouchButton {
    id: row
    Accessible.name: row.name
    Accessible.description: row.isActive && row.isOpen ? qsTr("In the controller and open here") : row.isActive ? qsTr("In the controller")
        : row.isOpen ? qsTr("Open on this panel") : ""

    required property string name
    required property int version
    required property string summary
    required property bool isOpen
    required property bool isActive
    required property var shape
    property bool holds

    implicitHeight: Theme.size.touch

    background: Rectangle {
        radius: Theme.size.radius
        color: row.holds || row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: row.holds ? Theme.color.touch : Theme.color.line }
    }
    Item {
        anchors.fill: parent
        CurveThumbnail {
            id: drawing
            anchors { left: parent.left; leftMargin: Theme.size.accent; verticalCenter: parent.verticalCenter }
            width: height
            height: Math.round(parent.height * 0.6)
            points: row.shape
            color: row.holds ? Theme.color.touch : Theme.color.secondaryInk
            lineWidth: Theme.size.curve
        }
        Column {
            anchors { left: drawing.right; right: marks.left; margins: Theme.size.padding; leftMargin: Theme.size.accent; rightMargin: Theme.size.accent; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.outline
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: row.name
                font.weight: Font.DemiBold
            }
            Label {
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: Theme.fill(qsTr("v%1 · %2"), [row.version, row.summary])
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Column {
            id: marks
            anchors { right: parent.right; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.outline
            IconLabel {
                visible: row.isOpen
                code: Theme.icon.edit
                color: Theme.color.secondaryInk
            }
            IconLabel {
                visible: row.isActive
                code: Theme.icon.machine
                color: Theme.color.secondaryInk
            }
        }
    }
}
