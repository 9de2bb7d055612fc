// SPDX-License-Identifier: Apache-2.0
// The skipped cuts of the packing machine with the last cause. A tap opens the numbers of marks, cuts and film.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

RunTile {
    id: card

    readonly property PackingLine line: Controller.packing

    objectName: "skippedCutsCard"
    title: qsTr("Skipped cuts")
    quantities: [Explanations.FilmSaved]
    onClicked: Frame.open("Run/PackingSheet", {})

    Label {
        id: count
        objectName: "skippedCuts"
        readonly property string value: "packer.cuts_skipped"
        text: Theme.count(Controller.telemetry[value] ?? NaN, 0)
        color: Controller.fresh && card.line.fresh ? Theme.color.ink : Theme.color.disabledInk
        font { pixelSize: Theme.size.title; bold: true }
    }
    Label {
        objectName: "lastSkip"
        visible: card.line.lastSkipText.length > 0
        width: parent.width
        height: Math.max(Theme.size.caption, parent.height - count.height)
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: qsTr("Last: %1").arg(card.line.lastSkipText)
        color: Controller.fresh && card.line.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk
        font.pixelSize: Theme.size.caption
    }
}
