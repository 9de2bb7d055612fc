// SPDX-License-Identifier: Apache-2.0
// The frames of the line as text, the newest at the bottom. A tap displays all values and bytes of one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property FrameList frames: Maintenance.frames

    onShownChanged: shown => section.frames.watched = shown

    Segmented {
        id: filters
        anchors { left: parent.left; right: keys.left; rightMargin: Theme.size.spacing; top: parent.top }
        choices: [{ key: FrameList.Filter.All, name: "framesAll", text: qsTr("All") },
            { key: FrameList.Filter.Errors, name: "framesErrors", text: qsTr("Errors") },
            { key: FrameList.Filter.Commands, name: "framesCommands", text: qsTr("Commands") },
            { key: FrameList.Filter.Writes, name: "framesWrites", text: qsTr("Writes") }]
        current: section.frames.filter
        onChosen: key => section.frames.filter = key
    }
    Row {
        id: keys
        anchors { right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        Button {
            objectName: "framesPause"
            Accessible.name: section.frames.paused ? qsTr("Resume") : qsTr("Pause")
            kind: section.frames.paused ? Button.Primary : Button.Normal
            glyph: section.frames.paused ? Theme.icon.start : Theme.icon.pause
            onClicked: section.frames.paused = !section.frames.paused
        }
        Button {
            objectName: "framesClear"
            Accessible.name: qsTr("Clear")
            glyph: Theme.icon.remove
            onClicked: section.frames.clear()
        }
        Button {
            objectName: "framesExport"
            level: Access.Operator
            Accessible.name: qsTr("Export")
            glyph: Theme.icon.save
            enabled: section.frames.count > 0
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                section.frames.exportText()
                Frame.open("Parts/ReportFilesSheet", { title: qsTr("Frames as text") })
            }
        }
    }
    ListView {
        id: list
        objectName: "frameList"
        Accessible.role: Accessible.List
        Accessible.name: qsTr("Frames")
        property bool follows: true        // keeps the newest visible until the user scrolls up
        anchors { left: parent.left; right: parent.right; top: filters.bottom; bottom: parent.bottom; topMargin: Theme.size.spacing }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: section.frames
        onMovementStarted: follows = false
        onMovementEnded: follows = atYEnd
        onContentHeightChanged: if (follows) positionViewAtEnd()
        onCountChanged: if (follows) positionViewAtEnd()
        onHeightChanged: if (follows) positionViewAtEnd()
        delegate: FrameRow {
            required property int index
            width: list.width
            shaded: index % 2 === 0
        }
        TapHandler {
            onTapped: point => {
                const row = list.indexAt(point.position.x, point.position.y)
                section.frames.showDetail(row)
                if (row >= 0)
                    Frame.open("Maintenance/FrameSheet", {})
            }
        }
    }
    ScrollMark { view: list }
    Label {
        anchors.fill: list
        visible: list.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: qsTr("No frames of this kind.")
        color: Theme.color.secondaryInk
    }
}
