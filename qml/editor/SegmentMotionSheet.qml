// SPDX-License-Identifier: Apache-2.0
// The motions that the selected segment of a cam may have.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

ListPicker {
    id: sheet

    signal picked()

    title: qsTr("Motion of segment %1").arg(Editor.segments.selected + 1)
    current: Editor.segments.motion
    choices: [...Editor.segments.motions].map((text, index) => ({ key: index, text: text }))
    onChosen: key => {
        Editor.segments.setMotion(key)
        sheet.picked()
    }
}
