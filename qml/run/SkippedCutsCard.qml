// SPDX-License-Identifier: Apache-2.0
// The skipped cuts of the packing machine with their causes, and the film saved. A tap opens the numbers.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    readonly property PackingLine line: Controller.packing
    readonly property color inkColor: Controller.fresh && line.fresh ? Theme.color.ink : Theme.color.disabledInk

    component Figure: ValueTile {
        width: parent ? parent.width : 0
        labelSize: Theme.size.caption
        amountSize: Theme.size.title
    }

    Column {
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: Theme.size.padding }
        spacing: Theme.size.outline
        Figure {
            objectName: "skippedCuts"
            label: qsTr("Skipped cuts")
            value: "packer.cuts_skipped"
        }
        Figure {
            objectName: "emptyBags"
            label: qsTr("Bags without product")
            value: "packer.empty_bags"
        }
        Figure {
            objectName: "filmSaved"
            visible: Controller.telemetry[value] !== 0   // unknown is told, nothing is not
            label: qsTr("Film saved")
            value: "packer.film_saved"
        }
        Label {
            objectName: "lastSkip"
            visible: card.line.lastSkipText.length > 0
            width: parent.width
            height: Math.max(Theme.size.caption, card.height - Theme.size.padding - y)
            verticalAlignment: Text.AlignTop
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: qsTr("Last: %1").arg(card.line.lastSkipText)
            color: card.inkColor
            font.pixelSize: Theme.size.caption
        }
    }
    Explained {
        objectName: "skippedCutsCard"
        Accessible.name: qsTr("Skipped cuts")
        quantities: [Explanations.FilmSaved]
        onClicked: Frame.open("Run/PackingSheet", {})
    }
}
