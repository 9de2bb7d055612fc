// SPDX-License-Identifier: Apache-2.0
// The base of everything that a finger presses. A keyboard reaches it by Tab alone, and presses it by Space or Enter while
// the focus ring is around it; a touch does not move the focus.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T

T.AbstractButton {
    id: button
    Accessible.role: Accessible.Button
    Accessible.name: button.text
    focusPolicy: Qt.TabFocus
    Keys.onReturnPressed: button.clicked()
    Keys.onEnterPressed: button.clicked()
}
