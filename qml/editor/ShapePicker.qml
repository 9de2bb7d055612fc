// SPDX-License-Identifier: Apache-2.0
// A list of choices that are curves; each choice is {key, text, note, shape}.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Plot

ListPicker {
    id: picker

    panelWidth: width * 0.7

    delegate: ChoiceRow {
        id: row
        required property var modelData
        objectName: "choice_" + modelData.key
        level: picker.level
        leftPadding: drawing.width + Theme.size.padding
        text: modelData.text
        note: modelData.note ?? ""
        holds: modelData.key === picker.current
        onClicked: picker.choose(modelData.key)
        CurveThumbnail {
            id: drawing
            x: Theme.size.padding
            anchors.verticalCenter: parent.verticalCenter
            width: 1.2 * height
            height: Theme.size.touch - 2 * Theme.size.spacing
            points: row.modelData.shape
            color: row.holds ? Theme.color.touch : Theme.color.secondaryInk
            lineWidth: Theme.size.curve
        }
    }
}
