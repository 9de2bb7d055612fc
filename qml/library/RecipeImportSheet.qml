// SPDX-License-Identifier: Apache-2.0
// Recipe files on a USB stick or in the panel's own folder; the consequence of the import is below the selected one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property int chosen: -1
    property string chosenDetail
    property bool chosenUsable

    readonly property RecipeFiles source: Recipes.files

    title: qsTr("Import a recipe")
    Component.onCompleted: sheet.source.look()

    // Searches again, to find a stick when it is plugged in.
    Timer {
        interval: Theme.lookAgainTime
        repeat: true
        running: sheet.chosen < 0
        onTriggered: sheet.source.refresh()
    }
    ListView {
        id: list
        objectName: "recipeFiles"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: takeButton.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.source.files
        delegate: ChoiceRow {
            required property int index
            required property string title
            required property string detail
            required property bool usable
            required note
            objectName: "recipeFile" + index
            width: list.width - 2 * Theme.size.accent
            text: title
            noteColor: usable || holds ? Theme.color.secondaryInk : Theme.color.fault
            holds: sheet.chosen === index
            onClicked: {
                sheet.chosen = index
                sheet.chosenDetail = detail
                sheet.chosenUsable = usable
            }
        }
    }
    ScrollMark { view: list }
    Label {
        objectName: "recipeFileDetail"
        anchors { left: parent.left; right: takeButton.left; rightMargin: Theme.size.padding; top: takeButton.top; bottom: parent.bottom }
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        minimumPixelSize: Theme.size.caption - 3
        text: sheet.chosen >= 0 ? sheet.chosenDetail : sheet.source.busy ? qsTr("Searching …")
            : list.count > 0 ? qsTr("Choose a file to view its content.")
            : qsTr("There is no recipe file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.").arg(sheet.source.ownFolder)
        color: sheet.chosen >= 0 ? (sheet.chosenUsable ? Theme.color.ink : Theme.color.fault) : Theme.color.secondaryInk
    }
    Button {
        id: takeButton
        objectName: "recipeTake"
        anchors { right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        enabled: sheet.chosen >= 0 && sheet.chosenUsable
        text: qsTr("Import")
        onClicked: {
            sheet.source.take(sheet.chosen)
            sheet.closed()
        }
    }
}
