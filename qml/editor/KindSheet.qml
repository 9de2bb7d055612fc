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
        qsTr("From one speed to another constant speed"), qsTr("A curve through knots that follows a master"),
        qsTr("Approach, probe, press, hold, return"), qsTr("Segments by laws, one after another, that follow a master")]

    title: qsTr("New program")
    note: qsTr("Replaces the recipe on this page; Undo restores the old recipe")
    current: Editor.kind
    choices: sheet.names.map((text, index) => ({ key: index + 1, text: text, note: sheet.notes[index] }))
}
