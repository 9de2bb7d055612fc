// SPDX-License-Identifier: Apache-2.0
// The setup of a new panel, step by step: language, controller, PINs, machine, a first recipe.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    property int step
    property real rightInset               // width of a keypad, which covers nothing

    readonly property var steps: [
        { title: qsTr("Language"), source: "FirstLanguage.qml" },
        { title: qsTr("Controller"), source: "FirstController.qml" },
        { title: qsTr("Access"), source: "FirstPin.qml" },
        { title: qsTr("Machine"), source: "FirstMachine.qml" },
        { title: qsTr("First recipe"), source: "FirstRecipe.qml" }
    ]
    readonly property bool isLast: step === steps.length - 1

    function goOn(): void {
        if (!page.isLast) {
            page.step += 1
            return
        }
        if (Editor.edited)
            Recipes.save()
        Controller.startPermit.turnOn()
        Frame.openPage("motion")
        if (Editor.programDownload.canDownload)
            Frame.open("Download/DownloadSheet", {})
        Settings.endFirstStart() // closes this page
    }

    Rectangle {
        anchors.fill: parent
        color: Theme.color.ground
        MouseArea { anchors.fill: parent }
    }
    Card {
        anchors { fill: parent; margins: Theme.size.gap; rightMargin: Theme.size.gap + page.rightInset }
        Label {
            id: count
            anchors { left: parent.left; top: parent.top; margins: Theme.size.padding }
            text: Theme.fill(qsTr("First start · %1 of %2"), [page.step + 1, page.steps.length])
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            id: heading
            objectName: "firstTitle"
            anchors { left: count.left; top: count.bottom }
            text: page.steps[page.step].title
            font { pixelSize: Theme.size.title; bold: true }
        }
        Loader {
            id: loader
            anchors { left: parent.left; right: parent.right; top: heading.bottom; bottom: backKey.top; margins: Theme.size.padding; topMargin: Theme.size.spacing }
            source: page.steps[page.step].source
        }
        Button {
            id: backKey
            objectName: "firstBack"
            anchors { left: parent.left; bottom: parent.bottom; margins: Theme.size.padding }
            width: 2 * Theme.size.touch
            visible: page.step > 0 && page.rightInset === 0
            text: qsTr("Back")
            onClicked: page.step -= 1
        }
        Button {
            objectName: "firstNext"
            anchors { right: parent.right; bottom: parent.bottom; margins: Theme.size.padding }
            width: Math.min(parent.width - 2 * Theme.size.padding, Math.max(implicitWidth, 2.4 * Theme.size.touch))
            kind: Button.Primary
            text: page.isLast ? qsTr("Finish") : qsTr("Next")
            onClicked: page.goOn()
        }
    }
}
