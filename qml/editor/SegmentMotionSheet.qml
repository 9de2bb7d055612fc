// SPDX-License-Identifier: Apache-2.0
// The motions that the selected segment of a cam may have, beside its curve.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

ShapePicker {
    id: sheet

    beside: true
    panelWidth: besideWidth
    panelHeight: height
    level: Access.Technician
    title: qsTr("Motion of segment %1").arg(Editor.cam.segments.selected + 1)
    current: Editor.cam.segments.motion
    choices: [...Editor.cam.segments.motions].map((motion, index) => ({ key: index, text: motion.name, shape: motion.shape }))
    onChosen: key => {
        Editor.cam.segments.setMotion(key)
        Frame.open("Editor/SegmentSheet", {})
    }
}
