// SPDX-License-Identifier: Apache-2.0
// The order that the controller counts, in full, and what a person may do with it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    readonly property color figureInk: Orders.fresh || !Orders.current.underWay ? Theme.color.ink : Theme.color.disabledInk

    color: Theme.color.inset
    implicitHeight: Math.max(words.height, keys.height) + 2 * Theme.size.spacing

    Column {
        id: words
        anchors { left: parent.left; right: keys.left; verticalCenter: parent.verticalCenter; margins: Theme.size.spacing; rightMargin: Theme.size.padding }
        spacing: Theme.size.accent
        Label {
            objectName: "currentTitle"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Theme.fill(qsTr("%1 · %2"), [Orders.current.title, Orders.current.stateText])
            font.weight: Font.DemiBold
        }
        Label {
            objectName: "currentProgress"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Orders.endText.length > 0 ? Orders.current.progress + " · " + Orders.endText : Orders.current.progress
            color: card.figureInk
            font { pixelSize: Theme.size.value; weight: Font.DemiBold }
        }
        ProgressBar {
            width: parent.width
            implicitHeight: Theme.size.spacing
            progress: Orders.current.fraction
        }
        Label {
            objectName: "currentCounts"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Theme.fill(qsTr("good %1 · rejected %2 · empty %3"), [Theme.count(Orders.current.good, 0), Theme.count(Orders.current.rejected, 0), Theme.count(Orders.current.empty, 0)])
            color: card.figureInk
        }
        Label {
            objectName: "currentFacts"
            width: parent.width
            wrapMode: Text.WordWrap
            text: Orders.current.underWay ? Orders.current.facts + " · " + Orders.current.actionText : Orders.current.facts
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Column {
        id: keys
        anchors { right: parent.right; verticalCenter: parent.verticalCenter; rightMargin: Theme.size.spacing }
        spacing: Theme.size.spacing
        width: Math.round(card.width * 0.3)
        Button {
            objectName: "orderCheckedNow"
            level: Access.Operator
            width: parent.width
            text: qsTr("First bag checked")
            onClicked: if (Access.ask(Access.Operator)) Frame.open("Orders/CheckedBySheet", {})
        }
        Button {
            objectName: "orderEnd"
            visible: Orders.current.underWay
            level: Access.Operator
            width: parent.width
            text: qsTr("End order")
            onClicked: if (Access.ask(Access.Operator)) Frame.open("Orders/EndOrderSheet", {})
        }
    }
}
