// SPDX-License-Identifier: Apache-2.0
// The way to a new user: level and name, the keyboard for another name, the PIN.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

QtObject {
    id: user

    function add(): void {
        const level = Access.protectedByPins ? Access.Operator : Access.Service
        user.open(level, Access.freeName(level))
    }
    function open(level: int, name: string): void {
        Frame.open("Access/NewUserSheet", {
            level: level, name: name, onNameRequested: (level, name) => user.enterName(level, name),
            onPinRequested: (level, name) => user.enterPin(level, name)
        })
    }
    function enterName(level: int, name: string): void {
        Frame.open("Parts/TextSheet", {
            title: qsTr("Name of the user"), text: name, check: text => Access.nameRefusal(text),
            onAccepted: text => user.open(level, text)
        })
    }
    function enterPin(level: int, name: string): void {
        if (!Access.ask(Access.Service))
            return
        Frame.open("Access/NewPinSheet", { title: qsTr("PIN of %1").arg(name), level: level, holds: true, onEntered: pin => Access.addUser(name, level, pin) })
    }
}
