// SPDX-License-Identifier: Apache-2.0
// The choice of the language, each in its own name.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: step

    readonly property var languages: Settings.languages
    readonly property var names: Settings.languageNames

    Column {
        width: parent.width
        spacing: Theme.size.spacing
        Label {
            width: parent.width
            wrapMode: Text.WordWrap
            text: qsTr("The Stop button is always available. It is not an emergency stop: use the machine's emergency-stop switch.")
            color: Theme.color.secondaryInk
        }
        Repeater {
            model: step.languages
            ChoiceRow {
                required property int index
                required property string modelData
                objectName: "firstLanguage_" + modelData
                width: parent.width
                text: step.names[index]
                holds: Settings.language === modelData
                onClicked: Settings.language = modelData
            }
        }
    }
}
