// SPDX-License-Identifier: Apache-2.0
// One number of the running program, changed by steps or by the keypad, with what the change does and costs, and the key that
// applies it. What is not applied is not kept.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    required property string name          // of the recipe's number
    readonly property EditorField field: Editor.field(sheet.name)
    readonly property ProgramDownload load: Editor.programDownload
    readonly property bool busy: load.busy
    readonly property bool failed: load.state === ProgramDownload.State.Failed
    readonly property bool isChanged: field.shownValue !== before
    readonly property bool wantsReason: isChanged && load.state === ProgramDownload.State.Unapproved
    readonly property bool refused: isChanged && !busy && !load.canDownload && !wantsReason && load.state !== ProgramDownload.State.NothingToDo
    readonly property var steps: field.unit === "in" ? [0.01, 0.1, 1] : [0.1, 1, 10]
    property real before
    property real step: steps[1]
    property bool ordered                  // the download has begun

    objectName: "changeSheet"
    title: field.label
    note: Theme.fill(qsTr("%1 to %2"), [Theme.count(field.minimum, 0), Theme.joined(Theme.count(field.maximum, 0), field.unit)])
    panelWidth: Math.min(width * 0.9, 8 * Theme.size.commandKey)

    Component.onCompleted: {
        Editor.beginTrial()
        sheet.before = field.shownValue
    }
    Component.onDestruction: Editor.endTrial(sheet.ordered)
    Connections {
        target: sheet.load
        function onChanged() {
            if (sheet.ordered && sheet.load.state === ProgramDownload.State.Applied)
                sheet.closed()
        }
    }

    component Step: StepButton {
        width: Theme.size.commandKey
        height: Theme.size.commandKey
        level: sheet.field.neededLevel
        enabled: !sheet.busy
    }

    Step {
        id: less
        objectName: "changeLess"
        anchors { left: parent.left; top: parent.top }
        glyph: Theme.icon.minus
        Accessible.name: qsTr("Less")
        onClicked: sheet.field.step(-sheet.step)
    }
    TouchButton {
        id: value
        objectName: "changeValue"
        anchors { left: less.right; right: more.left; top: parent.top; leftMargin: Theme.size.spacing; rightMargin: Theme.size.spacing }
        height: less.height
        level: sheet.field.neededLevel
        enabled: !sheet.busy
        Accessible.name: Theme.fill(qsTr("Change: %1"), [sheet.field.label])
        detail: sheet.field.text
        background: Card {
            color: value.down ? Theme.color.touchTint : Theme.color.surface
            border { width: Theme.size.outline; color: Theme.color.touch }
        }
        onClicked: Frame.edit([sheet.field], 0, value, "")
        DistantNumber {
            anchors { left: parent.left; right: unit.left; verticalCenter: parent.verticalCenter; leftMargin: Theme.size.padding; rightMargin: Theme.size.spacing }
            height: Math.round(0.62 * parent.height)
            title: sheet.field.label
            text: sheet.field.text
            unit: sheet.field.unit
        }
        Label {
            id: unit
            anchors { right: parent.right; rightMargin: Theme.size.padding; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
            text: sheet.field.unit
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.title
        }
    }
    Step {
        id: more
        objectName: "changeMore"
        anchors { right: parent.right; top: parent.top }
        glyph: Theme.icon.plus
        Accessible.name: qsTr("More")
        onClicked: sheet.field.step(sheet.step)
    }
    Segmented {
        id: stepChoice
        objectName: "changeStep"
        anchors { left: parent.left; right: keypad.left; rightMargin: Theme.size.spacing; top: less.bottom; topMargin: Theme.size.spacing }
        choices: sheet.steps.map((step, index) => ({ key: step, text: Theme.number(step, step < 0.1 ? 2 : step < 1 ? 1 : 0), name: "changeStep" + index }))
        current: sheet.step
        onChosen: key => sheet.step = key
    }
    Button {
        id: keypad
        objectName: "changeKeypad"
        anchors { right: parent.right; top: stepChoice.top }
        width: Math.max(Theme.size.commandKey, implicitWidth)
        level: sheet.field.neededLevel
        enabled: !sheet.busy
        text: qsTr("Keypad")
        onClicked: Frame.edit([sheet.field], 0, keypad, "")
    }
    covered: reasons.active
    SheetInPlace {
        id: reasons
        below: sheet
        source: "WindowReasonSheet.qml"
    }
    Item {
        id: pictures
        readonly property bool known: sheet.isChanged && !sheet.refused && !sheet.wantsReason
        anchors { left: parent.left; right: parent.right; top: stepChoice.bottom; topMargin: Theme.size.padding; bottom: words.top; bottomMargin: Theme.size.spacing }
        ChangePicture {
            objectName: "changePicture"
            anchors { left: parent.left; right: parent.right; top: parent.top; bottom: film.visible ? film.top : parent.bottom; bottomMargin: film.visible ? Theme.size.spacing : 0 }
            visible: pictures.known && height > 2 * Theme.size.body
            speeds: sheet.load.changeSpeeds
        }
        LineFilm {
            id: film
            objectName: "changeFilm"
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            height: Math.min(parent.height, Math.max(Math.round(parent.height / 2), 6 * Theme.size.caption))
            visible: pictures.known && cuts.length > 0 && height > 4.5 * Theme.size.caption
            cuts: sheet.load.changeCuts
            nextText: sheet.load.changeLength
            bagLength: NaN
            position: 0
            live: false
        }
    }
    Column {
        id: words
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.accent
        Label {
            objectName: "changeText"
            width: parent.width
            wrapMode: Text.WordWrap
            text: sheet.refused && Editor.severity === Editor.Severity.Bad ? Theme.unbroken(Editor.verdict) : sheet.isChanged || sheet.ordered ? Theme.unbroken(sheet.load.text) : Theme.fill(qsTr("The machine runs with %1."), [Theme.joined(sheet.field.text, sheet.field.unit)])
            color: sheet.failed || sheet.refused ? Theme.color.fault : Theme.color.ink
            font.pixelSize: pictures.known ? Theme.size.caption : Theme.size.body   // leaves the pictures their room
        }
        ProgressBar {
            width: parent.width
            visible: sheet.busy
            progress: sheet.load.progress
        }
    }
    footer: [
        Button {
            objectName: "changeCancel"
            level: sheet.busy ? Access.Operator : Access.Viewer
            text: sheet.busy ? qsTr("Cancel download") : qsTr("Close")
            onClicked: sheet.busy ? Editor.cancelDownload() : sheet.closed()
        },
        Button {
            objectName: "changeSuggestion"
            level: Editor.suggestionLevel
            visible: sheet.refused && Editor.suggestionText.length > 0
            text: Editor.suggestionText
            onClicked: Editor.applySuggestion()
        },
        Button {
            objectName: "changeReason"
            visible: sheet.wantsReason
            kind: Button.Primary
            text: qsTr("Give a reason …")
            onClicked: reasons.active = true
        },
        Button {
            objectName: "changeApply"
            level: Access.Operator
            visible: !sheet.wantsReason
            kind: Button.Primary
            enabled: sheet.load.canDownload && (sheet.isChanged || sheet.failed)
            text: sheet.failed ? qsTr("Try again") : Controller.state === Controller.State.Running ? qsTr("Apply at the next bag") : qsTr("Apply")
            onClicked: {
                sheet.ordered = true
                Editor.download()
            }
        }
    ]
}
