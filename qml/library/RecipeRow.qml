// SPDX-License-Identifier: Apache-2.0
// One recipe of the list: curve, name, version and figures; open or active.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Plot

ListRow {
    id: row
    Accessible.description: row.isActive && row.isOpen ? qsTr("In the controller and open here") : row.isActive ? qsTr("In the controller")
        : row.isOpen ? qsTr("Open on this panel") : ""

    required property string name
    required property int version
    required property string summary
    required property bool isOpen
    required property bool isActive
    required property var shape

    text: row.name
    note: Theme.fill(qsTr("v%1 · %2"), [row.version, row.summary])
    mark: ""
    leftPadding: drawing.width
    rightPadding: marks.width

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
