// SPDX-License-Identifier: Apache-2.0
// The way to a new user: level and name, the keyboard for another name, the PIN.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

QtObject {
    id: user

    readonly property int usualLevel: Access.protectedByPins ? Access.Operator : Access.Service

    // Returns true when somebody has chosen or typed something that the next step holds.
    function isChosen(level: int, name: string): bool {
        return level !== user.usualLevel || name !== Access.freeName(level)
    }
    function add(): void {
        user.open(user.usualLevel, Access.freeName(user.usualLevel))
    }
    function open(level: int, name: string): void {
        Frame.open("Access/NewUserSheet", {
            level: level, name: name, onNameRequested: (level, name) => user.enterName(level, name),
            onPinRequested: (level, name) => user.enterPin(level, name)
        })
    }
    function enterName(level: int, name: string): void {
        Frame.open("Parts/TextSheet", {
            title: qsTr("Name of the user"), text: name, holds: user.isChosen(level, name), check: text => Access.nameRefusal(text),
            onAccepted: text => user.open(level, text)
        })
    }
    function enterPin(level: int, name: string): void {
        if (!Access.ask(Access.Service))
            return
        Frame.open("Access/NewPinSheet", { title: qsTr("PIN of %1").arg(name), level: level, neededLevel: Access.Service, holds: user.isChosen(level, name), onEntered: pin => Access.addUser(name, level, pin) })
    }
}
