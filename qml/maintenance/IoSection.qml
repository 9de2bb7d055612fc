// SPDX-License-Identifier: Apache-2.0
// The controller's inputs and outputs, and its fault and warning bits, live.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property IoList io: Maintenance.io

    onShownChanged: shown => section.io.watched = shown

    Flickable {
        id: list
        objectName: "ioList"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top; bottomMargin: Theme.size.spacing }
        contentHeight: Math.max(pins.height, bits.height)
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: pins
            width: Math.round((list.width - 3 * Theme.size.padding) * 0.54)
            spacing: Theme.size.spacing
            IoColumn {
                objectName: "ioInputs"
                width: parent.width
                title: qsTr("Inputs (counted by the controller)")
                io: section.io
                side: Io.Input
            }
            IoColumn {
                objectName: "ioOutputs"
                width: parent.width
                title: qsTr("Outputs")
                io: section.io
                side: Io.Output
            }
        }
        Column {
            id: bits
            anchors { left: pins.right; leftMargin: 2 * Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding }
            spacing: Theme.size.spacing
            IoColumn {
                objectName: "ioFaults"
                width: parent.width
                title: qsTr("Fault bits")
                io: section.io
                side: Io.Fault
                withValues: false
            }
            IoColumn {
                objectName: "ioWarnings"
                width: parent.width
                title: qsTr("Warning bits")
                io: section.io
                side: Io.Warning
                withValues: false
            }
        }
    }
    ScrollMark { view: list }
    Label {
        id: foot
        objectName: "ioText"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        wrapMode: Text.WordWrap
        text: section.io.stale ? qsTr("No data from the controller: grey values were received last.")
            : qsTr("The controller reports the counts of its inputs, not the levels of its pins. A filled lamp means on.")
        color: section.io.stale ? Theme.color.warning : Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
