// SPDX-License-Identifier: Apache-2.0
// The fault that stopped the machine: what it is, what broke its limit and where, and what to do, beside the key Reset. A tap
// opens the alarm.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

TouchButton {
    id: card

    readonly property AlarmDetail alarm: Alarms.urgent
    readonly property bool jammed: alarm.code === "C-09"
    readonly property JamWatch jam: Maintenance.packing.jam
    readonly property bool torqueKnown: jammed && jam.limitPercent > 0 && !isNaN(jam.jam.y)
    readonly property bool measured: Alarms.urgentMeasure.value > Alarms.urgentMeasure.limit || torqueKnown
    readonly property int others: Controller.alarmTexts.length - 1

    onJammedChanged: card.jam.setWatchedBy(card, card.jammed)
    Component.onCompleted: card.jam.setWatchedBy(card, card.jammed)
    Component.onDestruction: card.jam.setWatchedBy(card, false)

    objectName: "faultCard"
    Accessible.name: alarm.title
    detail: alarm.action
    background: Card { border { width: Theme.size.outline; color: Theme.color.fault } }
    onClicked: {
        if (card.others > 0) {
            Frame.openPage("alarms")
            return
        }
        Alarms.showUrgent()
        Frame.open("Alarms/AlarmSheet", {})
    }

    IconLabel {
        id: sign
        anchors { left: parent.left; top: parent.top; margins: Theme.size.padding }
        code: Theme.icon.fault
        color: Theme.color.fault
        font.pixelSize: Theme.size.largeIcon
    }
    Label {
        id: title
        objectName: "faultTitle"
        anchors { left: sign.right; right: arrow.left; top: parent.top; leftMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        fontSizeMode: Text.HorizontalFit
        text: card.alarm.title
        font { pixelSize: Theme.size.value; bold: true }
    }
    IconLabel {
        id: arrow
        anchors { right: parent.right; top: parent.top; margins: Theme.size.spacing }
        code: Theme.icon.next
        color: Theme.color.touch
        font.pixelSize: Theme.size.title
    }
    Label {
        id: facts
        objectName: "faultFacts"
        anchors { left: title.left; right: parent.right; top: title.bottom; rightMargin: Theme.size.padding }
        wrapMode: Text.WordWrap
        readonly property var parts: [card.alarm.raisedText, card.jammed ? card.jam.lastText : card.alarm.detail, card.others > 0 ? qsTr("%1 more").arg(card.others) : ""]
        text: facts.parts.filter(part => part.length > 0).join(" · ")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    LimitScale {
        id: scale
        objectName: "faultScale"
        anchors { left: title.left; right: parent.right; top: facts.bottom; rightMargin: Theme.size.padding }
        visible: card.measured
        height: visible ? implicitHeight : 0
        value: card.torqueKnown ? Math.abs(card.jam.jam.y) : card.measured ? Alarms.urgentMeasure.value : NaN
        limit: card.torqueKnown ? Math.abs(card.jam.limitPercent) : card.measured ? Alarms.urgentMeasure.limit : NaN
        end: card.measured ? 1.1 * Math.max(value, limit) : 1
    }
    Label {
        objectName: "faultAction"
        Accessible.role: Accessible.AlertMessage
        Accessible.name: card.alarm.cause + " " + card.alarm.action
        anchors { left: title.left; right: parent.right; top: scale.bottom; bottom: parent.bottom; rightMargin: Theme.size.padding; bottomMargin: Theme.size.accent }
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Theme.unbroken(card.alarm.action)
        font { pixelSize: Theme.size.title; weight: Font.DemiBold }
    }
}
