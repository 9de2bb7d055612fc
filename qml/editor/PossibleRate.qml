// SPDX-License-Identifier: Apache-2.0
// How fast the cutter can be with this bag length: the part of the machine that sets it, and a bar that is green up to the
// highest rate, with the rate of the recipe as a mark.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    readonly property EditorField rate: Editor.field("rate_bags_per_min")
    readonly property string limitId: Editor.cutter.ramps.limitField
    readonly property EditorField limit: card.limitId.length > 0 ? Editor.field(card.limitId) : null
    readonly property bool refused: Editor.severity === Editor.Severity.Bad
    readonly property bool tooFast: card.rate.shownValue > card.rate.possible
    readonly property color markColor: card.tooFast ? Theme.color.fault : isNaN(card.rate.possible) ? Theme.color.secondaryInk : Theme.color.touch

    // Returns the left edge of a label that stands over or under the bar at this rate.
    function labelX(rate: real, width: real): real {
        return scale.x + Math.max(0, Math.min(scale.width - width, scale.place(rate) - width / 2))
    }

    MachineDrawing {
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: reason.top; margins: Theme.size.padding }
        fieldId: card.limitId
    }
    Label {
        id: reason
        objectName: "rateLimit"
        anchors { left: parent.left; right: parent.right; bottom: set.top; margins: Theme.size.padding; bottomMargin: Theme.size.spacing }
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: card.limit === null ? "" : Theme.fill(qsTr("Limit: %1 %2"), [card.limit.label, Theme.joined(card.limit.text, card.limit.unit)])
        color: card.refused ? Theme.color.fault : Theme.color.secondaryInk
    }
    Label {
        id: set
        objectName: "rateSet"
        x: card.labelX(card.rate.shownValue, width)
        anchors { bottom: scale.top; bottomMargin: Theme.size.accent }
        text: Theme.joined(card.rate.text, card.rate.unit)
        color: card.markColor
        font { pixelSize: Theme.size.title; bold: true }
    }
    LimitScale {
        id: scale
        objectName: "rateScale"
        anchors { left: parent.left; right: parent.right; bottom: most.top; margins: Theme.size.padding; bottomMargin: Theme.size.accent }
        thickness: 2 * Theme.size.padding
        value: card.rate.possible
        end: 1.25 * Math.max(1, card.rate.possible || 0, card.rate.shownValue || 0)
        set: card.rate.shownValue
        fill: Theme.color.good
        setColor: card.markColor
    }
    Label {
        anchors { left: scale.left; bottom: most.bottom }
        text: Theme.count(0, 0)
        color: Theme.color.secondaryInk
    }
    Label {
        id: most
        objectName: "rateMost"
        x: card.labelX(card.rate.possible || 0, width)
        anchors { bottom: parent.bottom; bottomMargin: Theme.size.padding }
        opacity: isNaN(card.rate.possible) ? 0 : 1
        text: qsTr("up to %1").arg(Theme.count(card.rate.possible, 1))
        color: Theme.color.secondaryInk
    }
    Explained {
        explained: () => Explanations.ofVerdict()
    }
}
