// SPDX-License-Identifier: Apache-2.0
// The crosses for a calibration of the touchscreen, one after another near the corners, and what came of them. The frame sees the touches.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Rectangle {
    id: cover

    readonly property bool waits: TouchCalibration.crossIndex >= 0

    color: Theme.color.surface

    MouseArea { anchors.fill: parent }
    Binding {
        target: TouchCalibration
        property: "cross"
        when: cover.waits
        value: {
            const center = cover.mapToItem(null, mark.x + mark.width / 2, mark.y + mark.height / 2)
            return Qt.point(center.x / cover.Window.width, center.y / cover.Window.height)
        }
    }
    Item {
        id: mark
        objectName: "touchCross"
        readonly property bool atRight: TouchCalibration.crossIndex === 1 || TouchCalibration.crossIndex === 2
        readonly property bool atBottom: TouchCalibration.crossIndex >= 2
        visible: cover.waits
        x: atRight ? parent.width - width - Theme.size.gap : Theme.size.gap
        y: atBottom ? parent.height - height - Theme.size.gap : Theme.size.gap
        width: Theme.size.touch
        height: Theme.size.touch
        Rectangle {
            anchors.centerIn: parent
            width: parent.width
            height: Theme.size.outline
            color: Theme.color.touch
        }
        Rectangle {
            anchors.centerIn: parent
            width: Theme.size.outline
            height: parent.height
            color: Theme.color.touch
        }
        Rectangle {
            anchors.centerIn: parent
            width: parent.width / 2
            height: width
            radius: width / 2
            color: "transparent"
            border { width: Theme.size.outline; color: Theme.color.touch }
        }
    }
    Column {
        anchors.centerIn: parent
        width: parent.width - 2 * (Theme.size.touch + 2 * Theme.size.gap)
        spacing: Theme.size.gap
        Label {
            objectName: "touchText"
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.Wrap
            text: cover.waits ? qsTr("Touch the center of the cross.") : TouchCalibration.message
            color: TouchCalibration.failed ? Theme.color.fault : Theme.color.ink
            font { pixelSize: Theme.size.title; bold: true }
        }
        Label {
            visible: cover.waits
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            text: Theme.fill(qsTr("Cross %1 of %2"), [TouchCalibration.crossIndex + 1, TouchCalibration.crossCount])
        }
        Row {
            anchors.horizontalCenter: parent.horizontalCenter
            visible: cover.waits || TouchCalibration.failed
            spacing: Theme.size.gap
            Button {
                objectName: "touchCancel"
                height: Theme.size.commandKey
                text: cover.waits ? qsTr("Cancel") : qsTr("Close")
                onClicked: TouchCalibration.cancel()
            }
            Button {
                objectName: "touchAgain"
                level: Access.Service
                visible: TouchCalibration.failed
                height: Theme.size.commandKey
                kind: Button.Primary
                text: qsTr("Try again")
                onClicked: TouchCalibration.begin()
            }
        }
    }
}
