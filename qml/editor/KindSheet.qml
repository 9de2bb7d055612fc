// SPDX-License-Identifier: Apache-2.0
// The choice of the kind of a new program.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

ListPicker {
    id: sheet

    readonly property var names: Editor.kindNames
    readonly property list<string> notes: [
        qsTr("A knife that follows the film while it seals"), qsTr("A distance, from rest to rest"),
        qsTr("From one speed to another, which is then held"), qsTr("A curve through points, behind a master"),
        qsTr("Approach, probe, press, hold, return")]

    title: qsTr("New program")
    note: qsTr("Takes the place of the recipe on this page; Undo brings it back")
    current: Editor.kind
    choices: sheet.names.map((text, index) => ({ key: index + 1, text: text, note: sheet.notes[index] }))
}
