// SPDX-License-Identifier: Apache-2.0
// One frame of the line: all its values, then its bytes; keys for the previous and the next frame.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property FrameList frames: Maintenance.frames
    readonly property var lines: frames.detailLines

    title: frames.detailTitle

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
            Label {
                objectName: "frameWords"
                width: parent.width
                wrapMode: Text.Wrap
                text: sheet.lines.join("\n")
            }
            Label {
                objectName: "frameBytes"
                width: parent.width
                visible: text.length > 0
                wrapMode: Text.WordWrap
                text: sheet.frames.detailBytes
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
    ScrollMark { view: view }
    footer: [
        Button {
            objectName: "framePrevious"
            text: qsTr("Earlier")
            enabled: sheet.frames.hasPrevious
            onClicked: sheet.frames.showPrevious()
        },
        Button {
            objectName: "frameNext"
            text: qsTr("Later")
            enabled: sheet.frames.hasNext
            onClicked: sheet.frames.showNext()
        }
    ]
}
