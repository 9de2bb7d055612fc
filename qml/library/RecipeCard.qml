// SPDX-License-Identifier: Apache-2.0
// The chosen recipe: its figures, open or active, and its actions.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    signal openRequested()
    signal copyRequested()
    signal renameRequested()
    signal versionsRequested()
    signal exportRequested()
    signal removeRequested()

    readonly property real third: Math.floor((keys.width - 2 * keys.spacing) / 3)
    readonly property int figureHeight: Math.round(1.5 * Theme.size.body)

    component Key: Button {
        width: card.third
    }

    Column {
        id: head
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding }
        Label {
            objectName: "chosenName"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Recipes.chosenName
            font { pixelSize: Theme.size.title; bold: true }
        }
        Label {
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            wrapMode: Text.Wrap    // below the smallest size
            maximumLineCount: 2
            text: Recipes.chosenNote
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        // The signs of the list in words.
        Row {
            id: place
            width: parent.width
            spacing: Theme.size.accent
            IconLabel {
                id: sign
                visible: code.length > 0
                code: Recipes.chosenIsActive ? Theme.icon.machine : Recipes.chosenIsOpen ? Theme.icon.edit : ""
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.body
            }
            Label {
                width: place.width - (sign.visible ? sign.width + place.spacing : 0)
                fontSizeMode: Text.HorizontalFit
                text: Recipes.chosenIsActive && Recipes.chosenIsOpen ? qsTr("In the controller and open here") : Recipes.chosenIsActive ? qsTr("In the controller") : Recipes.chosenIsOpen ? qsTr("Open on this panel") : qsTr("Stored on this panel")
                color: Theme.color.secondaryInk
                font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
            }
        }
    }
    // The figures scroll above the keys; without space for both, the keys come first and scroll with them.
    Flickable {
        id: list
        readonly property bool keysScroll: height < keys.height + card.figureHeight
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: openKey.top; margins: Theme.size.spacing }
        contentHeight: list.keysScroll ? figures.height + keys.height + Theme.size.spacing : list.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Flickable {
            id: upper
            anchors { left: parent.left; right: parent.right }
            y: list.keysScroll ? keys.height + Theme.size.spacing : 0
            height: list.keysScroll ? figures.height : list.height - keys.height - Theme.size.spacing
            contentHeight: figures.height
            clip: true
            interactive: !list.keysScroll
            boundsBehavior: Flickable.StopAtBounds
            Column {
                id: figures
                x: Theme.size.padding - Theme.size.spacing
                width: upper.width - 2 * x
                Repeater {
                    model: Recipes.figures
                    Item {
                        id: figure
                        required property string label
                        required property string value
                        width: figures.width
                        height: card.figureHeight
                        Label {
                            width: parent.width - amount.width - Theme.size.spacing
                            height: parent.height
                            fontSizeMode: Text.HorizontalFit
                            text: figure.label
                            color: Theme.color.secondaryInk
                        }
                        Label {
                            id: amount
                            anchors.right: parent.right
                            height: parent.height
                            text: figure.value
                            font.weight: Font.DemiBold
                        }
                    }
                }
            }
        }
        Flow {
            id: keys
            anchors { left: parent.left; right: parent.right }
            y: list.keysScroll ? 0 : upper.height + Theme.size.spacing
            spacing: Theme.size.spacing
            Key {
                objectName: "recipeRename"
                level: Access.Technician
                text: qsTr("Rename …")
                onClicked: card.renameRequested()
            }
            Key {
                objectName: "recipeCopy"
                level: Access.Technician
                text: qsTr("Copy …")
                onClicked: card.copyRequested()
            }
            Key {
                objectName: "recipeVersions"
                text: qsTr("Versions")
                onClicked: card.versionsRequested()
            }
            Key {
                objectName: "recipeCompare"
                text: qsTr("Compare")
                enabled: Recipes.total > 1
                onClicked: Frame.open("Library/RecipeComparisonSheet", { versions: false })
            }
            Key {
                objectName: "recipeRemove"
                text: qsTr("Delete …")
                enabled: !Recipes.chosenIsOpen
                onClicked: card.removeRequested()
            }
            Key {
                objectName: "recipeWindows"
                text: qsTr("Approved …")
                onClicked: {
                    Recipes.windows.begin()
                    Frame.open("Library/WindowsSheet", {})
                }
            }
            Key {
                objectName: "recipeCodes"
                visible: Scan.enabled
                text: qsTr("Codes …")
                onClicked: Frame.open("Library/CodesSheet", {})
            }
            Key {
                objectName: "recipeExport"
                level: Access.Operator
                text: qsTr("Export …")
                onClicked: card.exportRequested()
            }
        }
    }
    ScrollMark {
        view: list.keysScroll ? list : upper
        y: list.y + view.visibleArea.yPosition * view.height
    }
    Button {
        id: openKey
        objectName: "recipeOpen"
        level: Recipes.chosenIsOpen && !Editor.edited ? Access.Viewer : Access.Operator
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; margins: Theme.size.spacing }
        kind: Button.Primary
        text: Recipes.chosenIsOpen && !Editor.edited ? qsTr("Download …") : qsTr("Open")
        onClicked: card.openRequested()
    }
}
