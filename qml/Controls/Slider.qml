// SPDX-License-Identifier: Apache-2.0
// A slider between two ends; the handle and the whole height can be touched. `held` reports a drag by its values, `released`
// its end. Above the person's level it has a padlock, and a drag asks for the login.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

T.Slider {
    id: slider
    Accessible.role: Accessible.Slider
    Accessible.description: Permission.needs(slider.level)

    property int level                     // of the person who may move it; 0: everybody
    readonly property bool locked: enabled && level > Permission.level
    property bool known: true              // without a value there is no handle
    signal held(real value)
    signal released()

    focusPolicy: Qt.TabFocus
    implicitWidth: 3 * Theme.size.touch
    implicitHeight: Theme.size.touch
    leftPadding: Theme.size.handle / 2
    rightPadding: Theme.size.handle / 2
    onMoved: slider.held(slider.value)
    onPressedChanged: {
        if (!slider.pressed)
            slider.released()
    }

    background: Item {
        Rectangle {
            x: slider.leftPadding
            anchors.verticalCenter: parent.verticalCenter
            width: slider.availableWidth
            height: Theme.size.accent
            radius: height / 2
            color: Theme.color.line
        }
    }
    handle: Rectangle {
        visible: slider.known
        x: slider.leftPadding + slider.visualPosition * slider.availableWidth - width / 2
        y: (slider.height - height) / 2
        width: Theme.size.handle
        height: width
        radius: width / 2
        color: slider.pressed ? Theme.color.touch : Theme.color.surface
        border { width: Theme.size.curve; color: slider.enabled && !slider.locked ? Theme.color.touch : Theme.color.disabledInk }
    }

    Loader {
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        source: slider.locked ? "Padlock.qml" : ""
    }
}
