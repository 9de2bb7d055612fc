// SPDX-License-Identifier: Apache-2.0
// A question before an action that cannot be undone by a second touch: the consequence, and the choices.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property string question
    required property var ways             // each {key, text, primary, level}
    signal chosen(string key)

    panelWidth: width * 0.86
    panelHeight: 4.2 * Theme.size.touch

    Label {
        objectName: "question"
        anchors.fill: parent
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: sheet.question
    }
    footer: [
        Button {
            objectName: "confirmCancel"
            text: qsTr("Cancel")
            onClicked: sheet.closed()
        },
        Repeater {
            model: sheet.ways
            Button {
                required property var modelData
                objectName: "confirm_" + modelData.key
                level: modelData.level ?? Access.Viewer
                kind: modelData.primary ? Button.Primary : Button.Normal
                text: modelData.text
                onClicked: {
                    sheet.closed()
                    sheet.chosen(modelData.key)
                }
            }
        }
    ]
}
