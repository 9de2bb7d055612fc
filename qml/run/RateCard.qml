// SPDX-License-Identifier: Apache-2.0
// The rate of a packing machine in digits for three metres, over a bar up to what the machine can do, with what is set as a
// mark. A tap changes it, a held finger explains it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    readonly property bool led: Controller.masterSetting.leads
    readonly property EditorField field: Editor.field("rate_bags_per_min")
    readonly property bool isOpen: Editor.recipeName === Controller.active.name && Editor.kind === Controller.active.kind
    readonly property real setRate: Controller.active.rateBagsPerMin * (HandSpeed.percent < 100 ? HandSpeed.percent / 100 : 1)
    readonly property real possible: card.isOpen ? card.field.possible : NaN
    readonly property color noteColor: Controller.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk
    readonly property real naturalWidth: number.naturalWidth + 2 * Theme.size.padding

    implicitHeight: title.height + number.implicitHeight + scale.height + note.height + Theme.size.spacing + 3 * Theme.size.accent

    Label {
        id: title
        objectName: "rateTitle"
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: arrow.left; top: parent.top; topMargin: Theme.size.accent }
        fontSizeMode: Text.HorizontalFit
        text: card.led ? qsTr("Rate of the line, bags/min") : HandSpeed.percent < 100 ? Theme.fill(qsTr("Slowed to %1, bags/min"), [Theme.joined(Theme.count(HandSpeed.percent, 0), "%")]) : qsTr("Rate, bags/min")
        readonly property bool slowed: HandSpeed.percent < 100 && !card.led
        color: slowed && Controller.fresh ? Theme.color.ink : card.noteColor
        font { pixelSize: Theme.size.caption; weight: slowed ? Font.DemiBold : Font.Normal }
    }
    IconLabel {
        id: arrow
        anchors { right: parent.right; top: parent.top; margins: Theme.size.accent }
        code: Theme.icon.next
        opacity: card.led || explained.locked ? 0 : 1
        color: Theme.color.touch
        font.pixelSize: Theme.size.body
    }
    DistantNumber {
        id: number
        objectName: "rateNumber"
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding; top: title.bottom; topMargin: Theme.size.spacing; bottom: scale.top; bottomMargin: Theme.size.accent }
        title: qsTr("Rate")
        unit: qsTr("bags/min")
        text: Theme.count(Controller.live.rateBagsPerMin, 1)
        stale: !Controller.fresh
    }
    LimitScale {
        id: scale
        anchors { left: number.left; right: number.right; bottom: note.top }
        value: Controller.live.rateBagsPerMin
        end: Math.max(1, isNaN(card.possible) ? Controller.active.rateBagsPerMin : card.possible, Controller.active.rateBagsPerMin)
        set: card.led ? NaN : card.setRate
        stale: !Controller.fresh
    }
    Label {
        id: note
        objectName: "rateNote"
        anchors { left: number.left; right: most.left; bottom: parent.bottom; bottomMargin: Theme.size.accent }
        fontSizeMode: Text.HorizontalFit
        text: card.led && Controller.masterSetting.lineText !== "" ? Controller.masterSetting.lineText : qsTr("%1 bags").arg(Theme.count(Controller.bags.count, 0))
        color: card.noteColor
        font.pixelSize: Theme.size.caption
    }
    Label {
        id: most
        objectName: "rateMost"
        anchors { right: number.right; baseline: note.baseline }
        text: isNaN(card.possible) || card.led ? "" : qsTr("up to %1").arg(Theme.count(card.possible, 0))
        color: card.noteColor
        font.pixelSize: Theme.size.caption
    }
    Explained {
        id: explained
        objectName: "packingRate"
        field: card.led ? "" : "rate_bags_per_min"
        quantities: isNaN(Controller.live.sealTimeMs) ? [Explanations.Rate] : [Explanations.Rate, Explanations.LiveSealTime]
        onTapped: Controller.masterSetting.explainRate()
    }
}
