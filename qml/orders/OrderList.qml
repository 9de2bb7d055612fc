// SPDX-License-Identifier: Apache-2.0
// The orders that were started, newest first, with their filter and their export.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: history

    readonly property PagedLog log: Orders.history

    LogFilterStrip {
        id: strip
        anchors { left: parent.left; right: parent.right; top: parent.top }
        filter: history.log.filter
    }
    Label {
        objectName: "historyEmpty"
        anchors.centerIn: parent
        width: parent.width
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        visible: history.log.rows.count === 0 && !history.log.loading
        text: history.log.filter.active ? qsTr("No order matches the filter.") : qsTr("No order was started yet.")
        color: Theme.color.secondaryInk
    }
    ListView {
        id: list
        objectName: "orderList"
        anchors { fill: parent; topMargin: strip.visible ? strip.height + Theme.size.spacing : 0 }
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: history.log.rows
        delegate: ListRow {
            required property int index
            required property string title
            required property string stateText
            required property string progress
            required property string facts
            required property string clockNote
            required property double startedMs
            required property double endedMs
            required property double rejected
            required property double empty
            objectName: "order" + index
            onClicked: {
                Stops.shift.showOrder(title, startedMs, endedMs)
                Frame.openPage("stops")
            }
            frame: Theme.size.hairline
            text: title
            note: clockNote.length > 0 ? stateText + " · " + facts + " · " + clockNote : stateText + " · " + facts
            rightText: progress
            rightNote: Theme.fill(qsTr("rejected %1 · empty %2"), [Theme.count(rejected, 0), Theme.count(empty, 0)])
        }
    }
    ScrollMark { view: list }
}
