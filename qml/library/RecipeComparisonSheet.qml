// SPDX-License-Identifier: Apache-2.0
// The chosen recipe compared with its own versions or with another recipe: candidates on the left, differences on the right.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    required property bool versions
    property int chosen: -1
    property bool withNewest
    signal versionOpened(int row)

    function compare(): void {
        if (sheet.versions)
            Recipes.compareVersion(sheet.chosen, sheet.withNewest)
        else
            Recipes.compareOther(sheet.chosen)
    }

    title: sheet.versions ? qsTr("Versions of %1").arg(Recipes.chosenName) : qsTr("Compare %1").arg(Recipes.chosenName)
    Component.onCompleted: sheet.versions ? Recipes.listVersions() : Recipes.listOthers()

    ListView {
        id: list
        objectName: "candidates"
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        width: parent.width * 0.38
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Recipes.candidates
        delegate: ChoiceRow {
            required property int index
            required property string title
            required note
            objectName: "candidate" + index
            text: title
            holds: sheet.chosen === index
            onClicked: {
                sheet.chosen = index
                sheet.compare()
            }
        }
    }
    ScrollMark {
        view: list
        x: list.width - width
    }
    Item {
        anchors { left: list.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top; bottom: parent.bottom }
        Segmented {
            id: base
            visible: sheet.versions
            anchors { left: parent.left; right: parent.right; top: parent.top }
            choices: [{ key: false, text: qsTr("Changes"), name: "compareBefore" }, { key: true, text: qsTr("To newest"), name: "compareNewest" }]
            current: sheet.withNewest
            onChosen: key => {
                sheet.withNewest = key
                sheet.compare()
            }
        }
        DifferenceRow {
            id: head
            anchors { left: parent.left; right: parent.right; top: base.visible ? base.bottom : parent.top }
            visible: Recipes.compared
            name: ""
            activeText: Recipes.beforeTitle
            editedText: Recipes.afterTitle
            header: true
        }
        ListView {
            id: rows
            anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: openButton.visible ? openButton.top : parent.bottom; bottomMargin: Theme.size.spacing }
            clip: true
            boundsBehavior: Flickable.StopAtBounds
            model: Recipes.differences
            delegate: DifferenceRow { width: rows.width }
        }
        Label {
            objectName: "comparisonHint"
            anchors.fill: rows
            visible: rows.count === 0
            wrapMode: Text.WordWrap
            text: Recipes.compared ? qsTr("No differences")
                : sheet.chosen < 0 ? (list.count === 0 ? qsTr("There is no other version to compare.") : qsTr("Choose an entry at the left."))
                : sheet.withNewest ? qsTr("This is the newest version.") : qsTr("This is the first version.")
            color: Theme.color.secondaryInk
        }
        Button {
            id: openButton
            objectName: "openVersion"
            level: Access.Operator
            anchors { right: parent.right; bottom: parent.bottom }
            visible: sheet.versions
            enabled: sheet.chosen >= 0
            kind: Button.Primary
            text: qsTr("Open this version")
            onClicked: sheet.versionOpened(sheet.chosen)
        }
    }
}
