// SPDX-License-Identifier: Apache-2.0
// Recipes: a list with a search on the left, the chosen one on the right; unsaved edits are above both.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    function offerExport(all: bool): void {
        if (!Access.ask(Access.Operator))
            return
        Recipes.offerExport(all)
        Frame.open("Parts/ReportFilesSheet", { title: qsTr("Export as JSON"), files: Recipes.exports })
    }
    // Opens that version, -1: the chosen recipe. Unsaved edits would be lost, so the user decides.
    function open(version: int): void {
        if (!Editor.edited) {
            page.reallyOpen(version)
            return
        }
        Frame.open("Parts/ConfirmSheet", {
            title: qsTr("%1 is not saved").arg(Editor.recipeName),
            question: qsTr("The recipe was edited. Opening another recipe without saving discards the edits."),
            ways: [{ key: "discard", text: qsTr("Discard edits"), primary: false, level: Access.Operator },
                { key: "save", text: qsTr("Save as version %1").arg(Recipes.nextVersion), primary: true, level: Access.Operator }],
            onChosen: key => {
                if (key === "save")
                    Recipes.save()
                page.reallyOpen(version)
            }
        })
    }
    function reallyOpen(version: int): void {
        if (version >= 0)
            Recipes.openVersion(version)
        else
            Recipes.open()
        Frame.open("Download/DownloadSheet", {})
    }
    function name(title: string, suggestion: string, named: var): void {
        if (!Access.ask(Access.Technician))
            return
        Recipes.wantedName = suggestion
        Frame.open("Parts/TextSheet", {
            title: title, text: suggestion, level: Access.Technician, problem: Qt.binding(() => Recipes.nameProblem),
            onEdited: text => Recipes.wantedName = text, onAccepted: () => named()
        })
    }
    function create(): void {
        if (!Access.ask(Access.Technician))
            return
        Frame.open("Editor/KindSheet", {
            note: qsTr("A new recipe of this kind, with the data of this machine"), current: 0,
            onChosen: kind => page.name(qsTr("Name of the new recipe"), "", () => Recipes.create(kind))
        })
    }
    function importFile(): void {
        Recipes.files.scan()
        Frame.open("Parts/OfferSheet", {
            title: qsTr("Import recipes"), exchange: Recipes.files, offers: Recipes.files.files, level: Access.Operator, actionText: qsTr("Import"),
            allText: Qt.binding(() => Recipes.files.news > 1 ? qsTr("Import all %1").arg(Recipes.files.news) : ""),
            onAllAccepted: () => {
                Recipes.files.takeAll()
                Frame.close()
            },
            emptyText: qsTr("There is no recipe file on a USB stick or in %1. Plug a stick in; the panel finds it automatically.").arg(Recipes.files.ownFolder),
            onAccepted: row => {
                Recipes.files.take(row)
                Frame.close()
            }
        })
    }
    function remove(): void {
        Frame.open("Parts/ConfirmSheet", {
            title: qsTr("Delete %1?").arg(Recipes.chosenName),
            question: qsTr("The recipe leaves the list; its versions are kept. Saving a recipe under this name restores them."),
            ways: [{ key: "remove", text: qsTr("Delete"), primary: true, level: Access.Technician }], onChosen: () => Recipes.remove()
        })
    }

    Row {
        id: tools
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "recipeSearch"
            width: tools.width - (clearButton.visible ? clearButton.width + tools.spacing : 0) - newButton.width - importButton.width - exportButton.width - 3 * tools.spacing
            label: qsTr("Search")
            rightText: Settings.setting("recipes.order").shown
            rightLabel { color: Theme.color.secondaryInk; font.pixelSize: Theme.size.caption }
            value: Recipes.search.length > 0 ? Recipes.search : Recipes.total === 1 ? qsTr("1 recipe") : qsTr("all %1 recipes").arg(Recipes.total)
            onClicked: Frame.open("Library/SearchSheet", {})
        }
        Button {
            id: clearButton
            objectName: "recipeSearchClear"
            Accessible.name: qsTr("End the search")
            visible: Recipes.search.length > 0
            glyph: Theme.icon.close
            onClicked: Recipes.search = ""
        }
        Button {
            id: newButton
            objectName: "recipeNew"
            level: Access.Technician
            text: qsTr("New …")
            onClicked: page.create()
        }
        Button {
            id: importButton
            objectName: "recipeImport"
            text: qsTr("Import …")
            onClicked: page.importFile()
        }
        Button {
            id: exportButton
            objectName: "recipeExportAll"
            level: Access.Operator
            text: qsTr("Export all …")
            enabled: Recipes.total > 0
            onClicked: page.offerExport(true)
        }
    }
    Card {
        id: state
        anchors { left: parent.left; right: parent.right; top: tools.bottom; topMargin: Theme.size.spacing }
        height: visible ? Theme.size.actionBar : 0
        readonly property bool isOffer: !Editor.edited && Recipes.message.length === 0 && Recipes.files.notice.length > 0
        visible: Editor.edited || Recipes.message.length > 0 || state.isOffer
        Label {
            objectName: "recipeMessage"
            anchors { left: parent.left; leftMargin: Theme.size.padding; right: stateKeys.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
            height: parent.height - Theme.size.spacing
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: Recipes.message.length > 0 ? Recipes.message : state.isOffer ? Recipes.files.notice : Editor.recipeVersion === 0 ? qsTr("%1 is not saved yet.").arg(Editor.recipeName)
                : qsTr("%1 was edited and is not saved.").arg(Editor.recipeName)
        }
        Row {
            id: stateKeys
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            spacing: Theme.size.spacing
            Button {
                objectName: "recipeRestore"
                level: Access.Technician
                visible: Recipes.canRestore
                text: qsTr("Restore")
                onClicked: Recipes.restore()
            }
            Button {
                objectName: "recipeMessageOk"
                visible: Recipes.message.length > 0
                text: qsTr("OK")
                onClicked: Recipes.dismissMessage()
            }
            Button {
                objectName: "recipeOffer"
                visible: state.isOffer
                kind: Button.Primary
                text: qsTr("View …")
                onClicked: page.importFile()
            }
            Button {
                objectName: "recipeSaveAs"
                level: Access.Technician
                visible: Recipes.message.length === 0 && Editor.edited
                text: qsTr("Save as …")
                onClicked: page.name(qsTr("Save under another name"), Editor.recipeName, () => Recipes.saveAs())
            }
            Button {
                objectName: "recipeSave"
                level: Access.Operator
                visible: Recipes.message.length === 0 && Editor.edited
                kind: Button.Primary
                text: qsTr("Save as version %1").arg(Recipes.nextVersion)
                onClicked: Recipes.save()
            }
        }
    }
    Card {
        id: left
        anchors { left: parent.left; top: state.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom; bottomMargin: page.bottomInset }
        width: Math.round(parent.width * 0.48)
        ListView {
            id: list
            objectName: "recipeList"
            anchors { fill: parent; margins: Theme.size.spacing }
            clip: true
            spacing: Theme.size.spacing
            boundsBehavior: Flickable.StopAtBounds
            model: Recipes.list
            delegate: RecipeRow {
                required property int index
                objectName: "recipe" + index
                holds: Recipes.chosen === index
                onClicked: Recipes.choose(index)
            }
        }
        ScrollMark { view: list }
        Label {
            objectName: "recipesEmpty"
            anchors { fill: parent; margins: Theme.size.padding }
            visible: list.count === 0
            wrapMode: Text.WordWrap
            text: !Recipes.ready ? qsTr("Reading the recipes …")
                : Recipes.search.length > 0 ? qsTr("No recipe name contains \"%1\". Change or clear the search.").arg(Recipes.search)
                : qsTr("There is no recipe yet. Create a recipe, or import one from a USB stick.")
            color: Theme.color.secondaryInk
        }
    }
    RecipeCard {
        anchors { left: left.right; leftMargin: Theme.size.gap; right: parent.right; top: left.top; bottom: left.bottom }
        visible: Recipes.chosenName.length > 0
        onOpenRequested: Recipes.chosenIsOpen && !Editor.edited ? Frame.open("Download/DownloadSheet", {}) : page.open(-1)
        onCopyRequested: page.name(qsTr("Name of the copy"), qsTr("%1 copy").arg(Recipes.chosenName), () => Recipes.copy())
        onRenameRequested: page.name(qsTr("New name of %1").arg(Recipes.chosenName), Recipes.chosenName, () => Recipes.rename())
        onVersionsRequested: Frame.open("Library/RecipeComparisonSheet", { versions: true, onVersionOpened: row => page.open(row) })
        onRemoveRequested: page.remove()
        onExportRequested: page.offerExport(false)
    }
}
