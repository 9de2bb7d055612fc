// SPDX-License-Identifier: Apache-2.0
// The window of a second panel on the same data folder: it waits for the first one to end, or is closed.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Window {
    id: window

    required property string folder

    title: "CamPanel"
    color: Theme.color.ground

    Banner {
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: Theme.size.padding }
        height: 2 * Theme.size.touch
        severity: Banner.Warning
        text: qsTr("Another CamPanel uses the data in %1. Close the other one: this panel then starts.").arg(window.folder)
        buttonText: qsTr("Close this window")
        onAccepted: Qt.quit()
    }
    Binding { target: Theme; property: "window"; value: Qt.size(window.width, window.height) }
}
