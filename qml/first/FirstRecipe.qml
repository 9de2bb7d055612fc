// SPDX-License-Identifier: Apache-2.0
// Name, bag length and rate of the first recipe, and its download; the other values have useful defaults. The name follows
// the length until one is typed.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

FirstStep {
    id: step

    readonly property real half: narrow ? width : Math.floor((inputsWidth - Theme.size.spacing) / 2)
    readonly property ProgramDownload program: Editor.programDownload
    readonly property bool failed: program.state === ProgramDownload.State.Failed
    readonly property bool ended: failed || program.state === ProgramDownload.State.Applied

    // The length is what everybody changes: its keypad is open at once.
    function enter(): void {
        if (Access.level >= bagLength.item.neededLevel)
            bagLength.clicked()
    }

    lit: "bag"
    Component.onCompleted: Editor.cutter.ramps.begin()

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
            id: bagLength
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
        level: Editor.suggestionLevel
        text: Editor.suggestionText
        onClicked: Editor.applySuggestion()
    }
    notes: [
        Label {
            objectName: "firstProgramText"
            width: parent.width
            wrapMode: Text.WordWrap
            text: Theme.unbroken(step.program.busy || step.ended || Editor.severity !== Editor.Severity.Bad ? step.program.text : "")
            color: step.failed ? Theme.color.fault : step.ended ? Theme.color.ink : Theme.color.secondaryInk
            font.weight: step.ended ? Font.DemiBold : Font.Normal
        },
        ProgressBar {
            width: parent.width
            visible: step.program.busy
            progress: step.program.progress
        }
    ]
}
