// SPDX-License-Identifier: Apache-2.0
// Name, bag length and rate of the first recipe; the other values have useful defaults.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: step

    readonly property bool narrow: width < 5 * Theme.size.touch // beside the keypad
    readonly property real half: narrow ? width : (width - Theme.size.spacing) / 2

    Component.onCompleted: Editor.cutter.ramps.begin()

    Column {
        width: parent.width
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "firstName"
            visible: !step.narrow
            width: parent.width
            label: qsTr("Name")
            value: Editor.recipeName
            onClicked: {
                Recipes.wantedName = Editor.recipeName
                Frame.open("Parts/TextSheet", {
                    title: qsTr("Name of the recipe"), text: Editor.recipeName, level: Access.Technician, problem: Qt.binding(() => Recipes.nameProblem),
                    onEdited: text => Recipes.wantedName = text, onAccepted: () => Recipes.rename()
                })
            }
        }
        Grid {
            columns: step.narrow ? 1 : 2
            spacing: Theme.size.spacing
            FieldTile {
                objectName: "first_bag_length_mm"
                field: "bag_length_mm"
                compact: false
                width: step.half
            }
            FieldTile {
                objectName: "first_rate_bags_per_min"
                field: "rate_bags_per_min"
                compact: false
                width: step.half
            }
        }
        Label {
            objectName: "firstVerdict"
            width: parent.width
            wrapMode: Text.WordWrap
            text: Theme.unbroken(Editor.verdict)
            color: Editor.severity === Editor.Severity.Bad ? Theme.color.fault : Theme.color.ink
        }
        Button {
            visible: Editor.suggestionText.length > 0
            text: Editor.suggestionText
            onClicked: Editor.applySuggestion()
        }
        Label {
            visible: !step.narrow
            width: parent.width
            wrapMode: Text.WordWrap
            text: qsTr("Next: Download, then Start.")
            color: Theme.color.secondaryInk
        }
    }
}
