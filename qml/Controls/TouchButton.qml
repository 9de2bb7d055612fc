// SPDX-License-Identifier: Apache-2.0
// The base of everything that a finger presses. A keyboard reaches it by Tab alone, and presses it by Space or Enter while
// the focus ring is around it; a touch does not move the focus. What the person may not do has a padlock: the tap asks for a
// login and acts after it.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

T.AbstractButton {
    id: button

    property int level                     // of the person who may press it; 0: everybody
    property bool waitsForLogin: true      // false: a login never carries out the tap
    property string detail                 // what stands in it beside its name
    readonly property bool locked: enabled && level > Permission.level

    Accessible.role: Accessible.Button
    Accessible.name: button.text
    Accessible.description: button.locked && button.detail.length > 0 ? button.detail + ", " + Permission.needs(button.level)
        : button.detail + Permission.needs(button.level)
    onClicked: if (button.waitsForLogin) Permission.tap(button, () => button.clicked())
    focusPolicy: Qt.TabFocus
    Keys.onReturnPressed: button.clicked()
    Keys.onEnterPressed: button.clicked()

    Loader {
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        z: 1
        source: button.locked ? "Padlock.qml" : ""
    }
}
