// SPDX-License-Identifier: Apache-2.0
// The question whether a change of the screen stays. Without an answer it is undone: nobody may be able to read or touch the screen.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Rectangle {
    id: cover

    readonly property bool ofTouch: TouchCalibration.secondsLeft > 0

    color: Theme.color.surface

    MouseArea { anchors.fill: parent }
    Column {
        anchors.centerIn: parent
        width: parent.width - 2 * Theme.size.gap
        spacing: Theme.size.gap
        Label {
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.Wrap
            text: cover.ofTouch ? qsTr("Keep this calibration of the touchscreen?") : qsTr("Keep this rotation?")
            font { pixelSize: Theme.size.title; bold: true }
        }
        Label {
            objectName: "trialCountdown"
            width: parent.width
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.Wrap
            text: qsTr("Without an answer the earlier one returns in %1 s.").arg(cover.ofTouch ? TouchCalibration.secondsLeft : ScreenRotation.secondsLeft)
        }
        Row {
            anchors.horizontalCenter: parent.horizontalCenter
            spacing: Theme.size.gap
            Button {
                objectName: "trialBack"
                height: Theme.size.commandKey
                text: qsTr("Go back")
                onClicked: cover.ofTouch ? TouchCalibration.goBack() : ScreenRotation.goBack()
            }
            Button {
                objectName: "trialKeep"
                level: Access.Service
                height: Theme.size.commandKey
                kind: Button.Primary
                glyph: Theme.icon.check
                text: qsTr("Keep")
                onClicked: cover.ofTouch ? TouchCalibration.keep() : ScreenRotation.keep()
            }
        }
    }
}
