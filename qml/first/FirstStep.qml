// SPDX-License-Identifier: Apache-2.0
// The base of the steps of the first start: what is entered at the left, the picture of the packer with the notes at the
// right. Beside a keypad the inputs have the width, and the picture what is left below them.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: step

    property string lit                    // the part of the picture
    property string fieldId
    property bool detail                   // the step shows more than its first view; Back returns there
    property alias notes: notes.data
    default property alias inputs: inputs.data
    readonly property bool narrow: width < 5 * Theme.size.touch
    readonly property real inputsWidth: narrow ? width : Math.round(0.54 * width)
    readonly property real rightX: inputsWidth + Theme.size.padding

    // Called when Next has opened the step.
    function enter(): void { }

    Column {
        id: inputs
        width: step.inputsWidth
        spacing: Theme.size.spacing
    }
    FirstPicture {
        readonly property real free: step.height - y
        x: step.narrow ? 0 : step.rightX
        y: step.narrow ? inputs.height + Theme.size.spacing : 0
        width: step.narrow ? step.width : step.width - x
        height: step.narrow ? free : Math.min(0.62 * step.height, step.height - notes.height - Theme.size.spacing)
        visible: free >= Theme.size.touch
        small: step.narrow
        lit: step.lit
        fieldId: step.fieldId
    }
    Column {
        id: notes
        x: step.rightX
        width: step.width - x
        anchors.bottom: parent.bottom
        visible: !step.narrow
        spacing: Theme.size.spacing
    }
}
