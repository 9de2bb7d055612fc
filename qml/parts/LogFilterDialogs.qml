// SPDX-License-Identifier: Apache-2.0
// The sheets of a filter for a list of records: the filter, and the keyboard for its id and its word.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

QtObject {
    id: dialogs

    required property LogFilter filter
    required property string idLabel
    signal closed()

    function open(): void {
        Frame.open("Parts/LogFilterSheet", {
            filter: dialogs.filter, idLabel: dialogs.idLabel, onClosed: () => dialogs.closed(),
            onIdRequested: () => dialogs.enter(dialogs.idLabel, "id"), onWordRequested: () => dialogs.enter(qsTr("Word"), "word")
        })
    }
    function enter(title: string, member: string): void {
        Frame.open("Parts/TextSheet", {
            title: title, text: dialogs.filter[member], onAccepted: text => dialogs.filter[member] = text, onClosed: () => dialogs.open()
        })
    }
}
