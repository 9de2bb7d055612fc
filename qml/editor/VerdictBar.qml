// SPDX-License-Identifier: Apache-2.0
// The feasibility of the recipe, the controller's program if it differs, and the next step as one large button.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: bar

    property bool textsVisible: true
    required property bool technical       // other ramps are offered
    required property real pageWidth

    // Before the first edit the texts have the space; beside a wide sheet there is none.
    readonly property real room: width - next.width - 2 * Theme.size.touch - 4 * Theme.size.spacing
    readonly property bool goesBack: (Editor.undoLevel >= 0 || Editor.redoLevel >= 0) && room >= 0
    readonly property Item firstKey: offer.visible ? offer : goesBack ? back : next
    readonly property bool good: Editor.severity === Editor.Severity.Good
    readonly property color verdictColor: good ? Theme.color.good
        : Editor.severity === Editor.Severity.Warning ? Theme.color.warning : Theme.color.fault

    implicitHeight: Theme.size.actionBar

    IconLabel {
        id: mark
        visible: bar.textsVisible
        anchors { left: parent.left; leftMargin: Theme.size.padding; top: verdict.top; bottom: verdict.bottom }
        code: bar.good ? Theme.icon.good : Theme.icon.alert
        color: bar.verdictColor
    }
    Label {
        id: verdict
        objectName: "verdict"
        visible: bar.textsVisible
        anchors { left: mark.right; leftMargin: Theme.size.spacing; right: bar.firstKey.left; rightMargin: Theme.size.padding; top: parent.top; topMargin: Theme.size.spacing }
        height: (parent.height - 2 * Theme.size.spacing) * (bar.good ? 0.56 : 1)
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Theme.unbroken(Editor.verdict)
        font.weight: Font.DemiBold
    }
    Label {
        visible: bar.good && bar.textsVisible   // a refused recipe displays only its refusal
        anchors { left: verdict.left; right: verdict.right; top: verdict.bottom; bottom: parent.bottom; bottomMargin: Theme.size.spacing }
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Theme.unbroken(Editor.programDownload.state === ProgramDownload.State.Failed || Editor.programDownload.state === ProgramDownload.State.Applied
            ? Editor.programDownload.text : Editor.programDownload.controllerText)
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Explained {
        objectName: "verdictNumbers"
        Accessible.name: Editor.verdict
        anchors.rightMargin: bar.width - bar.firstKey.x   // it fills the bar beside the keys
        explained: () => Explanations.ofVerdict()
    }
    // A second tap on one spot is the same key: undo, redo and the next step never move.
    Button {
        id: offer
        objectName: "rampOffer"
        level: Access.Technician
        anchors { right: back.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: bar.technical && Editor.cutter.ramps.offerName.length > 0 && bar.room >= width
        width: Math.max(Theme.size.touch, Math.round(8.5 * Theme.size.caption))   // two words, for each text
        text: Editor.cutter.ramps.offerName
        note: Editor.cutter.ramps.offerRate
        onClicked: Editor.cutter.ramps.takeOffer()
    }
    Button {
        id: back
        objectName: "undo"
        Accessible.name: qsTr("Undo")
        anchors { right: forth.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: bar.goesBack
        width: Theme.size.touch
        kind: Button.Quiet
        glyph: Theme.icon.undo
        enabled: Editor.undoLevel >= 0
        level: Editor.undoLevel
        onClicked: Editor.undo()
    }
    Button {
        id: forth
        objectName: "redo"
        Accessible.name: qsTr("Redo")
        anchors { right: next.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: bar.goesBack
        width: Theme.size.touch
        kind: Button.Quiet
        glyph: Theme.icon.redo
        enabled: Editor.redoLevel >= 0
        level: Editor.redoLevel
        onClicked: Editor.redo()
    }
    NextStepButton {
        id: next
        width: Math.round(Math.min(2.4 * Theme.size.touch, 0.24 * bar.pageWidth))   // the same beside a sheet
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
    }
}
