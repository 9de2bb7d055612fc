// SPDX-License-Identifier: Apache-2.0
// The reasons of a stop as at most eight large keys; a group opens its own reasons.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: area

    required property ReasonKeys keys
    readonly property int columns: 4
    readonly property real keyHeight: Math.min((height - Theme.size.spacing) / 2, 2 * Theme.size.commandKey)

    Grid {
        id: grid
        anchors { left: parent.left; right: parent.right; top: parent.top }
        columns: area.columns
        spacing: Theme.size.spacing
        Repeater {
            model: area.keys.rows
            Button {
                required property int index
                required property string reason
                required property bool isPlanned
                required property bool opens
                required text
                objectName: "reason_" + reason
                level: opens ? Access.Viewer : Access.Operator
                width: (area.width - (area.columns - 1) * grid.spacing) / area.columns
                height: area.keyHeight
                textSize: Theme.size.command
                note: opens ? qsTr("more …") : isPlanned ? qsTr("planned") : ""
                onClicked: area.keys.touch(index)
            }
        }
    }
}
