// SPDX-License-Identifier: Apache-2.0
// The choice of the language, each in its own name.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

FirstStep {
    id: step

    readonly property SettingField language: Settings.setting("display.language")
    readonly property var languages: language.choices

    lit: "panel"

    Repeater {
        model: step.languages
        ChoiceRow {
            required property var modelData
            objectName: "firstLanguage_" + modelData.key
            width: step.inputsWidth
            text: modelData.text
            holds: step.language.key === modelData.key
            onClicked: step.language.choose(modelData.key)
        }
    }
    notes: Label {
        width: parent.width
        wrapMode: Text.WordWrap
        text: qsTr("The Stop button is always available. It is not an emergency stop: use the machine's emergency-stop switch.")
        color: Theme.color.secondaryInk
    }
}
