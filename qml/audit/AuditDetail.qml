// SPDX-License-Identifier: Apache-2.0
// One row of the audit trail in full.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: detail

    readonly property var lines: Audit.detail

    Flickable {
        id: view
        anchors.fill: parent
        contentHeight: body.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: body
            width: view.width - 2 * Theme.size.accent
            spacing: Theme.size.spacing
            Repeater {
                model: detail.lines
                Item {
                    id: line
                    required property int index
                    required property var modelData
                    width: body.width
                    height: Math.max(label.height, text.height)
                    Label {
                        id: label
                        width: Math.round(parent.width * 0.26)
                        text: line.modelData.label
                        color: Theme.color.secondaryInk
                    }
                    Label {
                        id: text
                        objectName: "auditDetail" + line.index
                        anchors { left: label.right; right: parent.right }
                        wrapMode: Text.Wrap
                        text: line.modelData.text
                        font.weight: Font.DemiBold
                    }
                }
            }
        }
    }
    ScrollMark { view: view }
}
