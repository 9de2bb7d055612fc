// SPDX-License-Identifier: Apache-2.0
// The film from the mark sensor to the knife as a moving picture, and the mark tracking as text. A tap opens the numbers.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    property bool faultAtKnife
    readonly property PackingLine line: Controller.packing
    readonly property bool fresh: Controller.fresh && line.fresh
    readonly property bool follows: line.markState === PackingLine.Tracking
    readonly property bool marksUsed: line.markState !== PackingLine.Off && line.markState !== PackingLine.Unknown

    IconLabel {
        id: sign
        visible: card.marksUsed && !gate.needsAll
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: state.verticalCenter }
        code: card.follows ? Theme.icon.check : Theme.icon.alert
        color: !card.fresh ? Theme.color.disabledInk : card.follows ? Theme.color.good : Theme.color.warning
        font.pixelSize: Theme.size.body
    }
    Label {
        id: state
        objectName: "markState"
        visible: !gate.needsAll
        anchors { left: sign.visible ? sign.right : parent.left; leftMargin: sign.visible ? Theme.size.accent : Theme.size.padding; top: parent.top; topMargin: Theme.size.spacing }
        text: card.line.known ? Controller.run.marks : Theme.unknownText
        color: !card.fresh ? Theme.color.disabledInk : card.follows || !card.marksUsed ? Theme.color.ink : Theme.color.warning
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    Label {
        id: markError
        objectName: "markError"
        readonly property string value: "packer.mark_error"
        visible: card.follows && !gate.visible
        anchors { right: more.left; rightMargin: Theme.size.padding; left: state.right; leftMargin: Theme.size.padding; verticalCenter: state.verticalCenter }
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: qsTr("mark error %1").arg(Theme.signedMeasure(Controller.telemetry[markError.value], 2, "mm"))
        color: card.fresh ? Theme.color.ink : Theme.color.disabledInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: gate
        objectName: "packingGate"
        // A long sentence takes the place of the marks.
        readonly property bool needsAll: words.advanceWidth > more.x - state.implicitWidth - sign.implicitWidth - 4 * Theme.size.padding
        visible: Controller.run.film.length > 0
        anchors { right: more.left; rightMargin: Theme.size.padding; left: needsAll ? parent.left : state.right; leftMargin: Theme.size.padding; verticalCenter: state.verticalCenter }
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: Controller.run.film
        TextMetrics {
            id: words
            font { pixelSize: Theme.size.smallestText; weight: Font.DemiBold }
            text: Controller.run.film
        }
        color: card.fresh ? Theme.color.warning : Theme.color.disabledInk
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    IconLabel {
        id: more
        anchors { right: parent.right; rightMargin: Theme.size.padding; verticalCenter: state.verticalCenter }
        code: Theme.icon.next
        color: Theme.color.touch
        font.pixelSize: Theme.size.title
    }
    LineFilm {
        id: picture
        objectName: "filmPicture"
        anchors { left: parent.left; right: parent.right; top: state.bottom; bottom: parent.bottom; margins: Theme.size.padding; topMargin: Theme.size.accent; bottomMargin: Theme.size.accent }
        cuts: Controller.run.cuts
        nextText: Controller.run.nextLength
        marks: card.line.seenMarks
        products: card.line.seenProducts
        scrap: Qt.point(Controller.run.scrapAhead, Controller.bags.isScrap ? 1 : 0)
        nextMark: card.line.nextMarkMm
        position: card.line.filmPositionMm
        speed: card.line.filmSpeedMmPerS
        sensor: card.line.known && card.line.marksWanted ? card.line.sensorMm : NaN
        window: card.line.windowMm
        knifeOpen: card.line.knifeOpen
        faultColor: card.faultAtKnife ? Theme.color.fault : "transparent"
        fresh: card.fresh
        sensorText: qsTr("Mark sensor")
        Connections {
            target: Controller
            function onLiveChanged(): void {
                picture.advance();
            }
        }
    }
    Explained {
        objectName: "filmCard"
        Accessible.name: qsTr("Film")
        quantities: [Explanations.MarkError]
        onClicked: Frame.open("Run/PackingSheet", {})
    }
}
