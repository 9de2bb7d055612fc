// SPDX-License-Identifier: Apache-2.0
// A key that switches an output on while it is held: from the touch until the finger is lifted or slides off.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

T.AbstractButton {
    id: key
    Accessible.role: Accessible.Button
    Accessible.name: qsTr("Try %1").arg(key.name)

    required property OutputTry trying
    required property int output           // its bit
    required property string name
    readonly property bool tries: trying !== null && trying.held === output
    readonly property bool possible: trying !== null && trying.possible

    implicitWidth: Math.max(Theme.size.touch, label.implicitWidth + 2 * Theme.size.padding)
    implicitHeight: Theme.size.touch
    text: qsTr("Try")

    // Sliding back onto the key does not switch on again: that needs a new touch.
    onPressed: trying.press(output)
    onPressedChanged: {
        if (!pressed)
            trying.release(output)
    }

    background: Rectangle {
        radius: Theme.size.radius
        color: key.tries ? Theme.color.touch : key.down || !key.possible ? Theme.color.inset : Theme.color.surface
        border { width: Theme.size.outline; color: key.possible ? Theme.color.touch : Theme.color.line }
    }
    Label {
        id: label
        anchors.centerIn: parent
        text: key.text
        color: key.tries ? Theme.color.touchInk : key.possible ? Theme.color.touch : Theme.color.secondaryInk
        font { pixelSize: Theme.size.body; weight: Font.DemiBold }
    }
}
