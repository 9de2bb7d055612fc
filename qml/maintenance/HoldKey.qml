// SPDX-License-Identifier: Apache-2.0
// A key that switches an output on while it is held: from the end of the ring until the finger is lifted or slides off.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

CommandButton {
    id: key
    Accessible.name: qsTr("Try %1").arg(key.name)

    required property OutputTry trying
    required property int output           // its bit
    required property string name
    readonly property bool tries: trying !== null && trying.held === output
    readonly property bool possible: trying !== null && trying.possible
    readonly property bool inFront: Window.active

    implicitWidth: Math.max(Theme.size.touch, label.implicitWidth + 2 * Theme.size.padding)
    implicitHeight: Theme.size.touch
    text: qsTr("Try")

    ready: possible && !Frame.covered
    onPressed: trying.touch(output)
    onCommanded: trying.press(output)
    onInFrontChanged: acted = true
    onPressedChanged: {
        if (!pressed)
            trying.release(output)
    }

    background: Rectangle {
        radius: Theme.size.radius
        color: key.tries ? Theme.color.touch : key.down || !key.possible ? Theme.color.inset : Theme.color.surface
        border { width: Theme.size.outline; color: key.possible && !key.locked ? Theme.color.touch : Theme.color.line }
    }
    Label {
        id: label
        anchors.centerIn: parent
        text: key.text
        color: key.tries ? Theme.color.touchInk : key.possible && !key.locked ? Theme.color.touch : Theme.color.secondaryInk
        font { pixelSize: Theme.size.body; weight: Font.DemiBold }
    }
}
