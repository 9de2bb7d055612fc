// SPDX-License-Identifier: Apache-2.0
// The choice of the kind of a new program.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

ShapePicker {
    id: sheet

    readonly property var kinds: Editor.kinds
    readonly property list<string> notes: [
        qsTr("A knife that follows the film while it seals"), qsTr("A distance, from rest to rest"),
        qsTr("From one speed to another constant speed"), qsTr("A curve through knots that follows a master"),
        qsTr("Approach, probe, press, hold, return"), qsTr("Segments by laws, one after another, that follow a master")]

    title: qsTr("New program")
    note: qsTr("Replaces the recipe on this page; Undo restores the old recipe")
    level: Access.Technician
    current: Editor.kind
    choices: sheet.kinds.map((kind, index) => ({ key: index + 1, text: kind.name, note: sheet.notes[index], shape: kind.shape }))
}
