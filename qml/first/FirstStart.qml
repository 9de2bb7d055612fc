// SPDX-License-Identifier: Apache-2.0
// The setup of a new panel, step by step: language, controller, PINs, machine, a first recipe with its download. It ends with
// Start, or with Finish.
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
    readonly property FirstStep view: loader.item as FirstStep
    readonly property bool narrow: rightInset > 0

    function goOn(): void {
        page.step += 1
        page.view.enter()
    }
    function goBack(): void {
        if (page.view.detail)
            page.view.detail = false
        else
            page.step -= 1
    }
    // A recipe that was not downloaded is saved all the same.
    function finish(): void {
        if (Editor.edited)
            Recipes.save()
        Controller.startPermit.turnOn()
        Frame.openPage("run")
        Settings.endFirstStart() // closes this page
    }
    function download(): void {
        Controller.startPermit.turnOn()
        Editor.download()
    }

    Connections {
        target: Controller
        function onStateChanged() {
            if (page.isLast && Controller.state === Controller.State.Running && !ProgramNames.isOtherMotion)
                page.finish()
        }
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
            anchors { left: parent.left; right: parent.right; top: heading.bottom; bottom: keys.top; margins: Theme.size.padding; topMargin: Theme.size.spacing }
            source: page.steps[page.step].source
        }
        Button {
            objectName: "firstBack"
            anchors { left: parent.left; bottom: parent.bottom; margins: Theme.size.padding }
            width: (page.narrow ? 1.5 : 2) * Theme.size.touch
            visible: page.step > 0 && x + width < keys.x
            text: qsTr("Back")
            onClicked: page.goBack()
        }
        Row {
            id: keys
            anchors { right: parent.right; bottom: parent.bottom; margins: Theme.size.padding }
            spacing: Theme.size.spacing
            readonly property real keyWidth: Math.min(parent.width - 2 * Theme.size.padding, 2.4 * Theme.size.touch)
            Button {
                objectName: "firstFinish"
                level: Access.Technician   // of the start permit
                width: Math.max(implicitWidth, keys.keyWidth)
                visible: page.isLast && !page.narrow
                text: qsTr("Finish")
                onClicked: page.finish()
            }
            Button {
                objectName: "firstCancelDownload"
                level: Access.Operator
                width: Math.max(implicitWidth, keys.keyWidth)
                visible: page.isLast && Editor.programDownload.busy
                text: qsTr("Cancel download")
                onClicked: Editor.cancelDownload()
            }
            Button {
                objectName: "firstDownload"
                level: Access.Technician
                width: Math.max(implicitWidth, keys.keyWidth)
                visible: page.isLast && !Editor.programDownload.busy
                kind: Button.Primary
                glyph: Theme.icon.download
                enabled: Editor.programDownload.canDownload
                text: Editor.programDownload.state === ProgramDownload.State.Failed ? qsTr("Try again") : qsTr("Download")
                onClicked: page.download()
            }
            Button {
                objectName: "firstNext"
                width: Math.max(implicitWidth, keys.keyWidth)
                visible: !page.isLast
                kind: Button.Primary
                text: qsTr("Next")
                onClicked: page.goOn()
            }
        }
    }
}
