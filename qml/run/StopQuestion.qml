// SPDX-License-Identifier: Apache-2.0
// The question for the reason of the present stop, in the place of the page; it goes when the machine runs.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: question

    objectName: "stopQuestion"
    border { width: Theme.size.outline; color: Theme.color.touch }
    MouseArea { anchors.fill: parent }
    Column {
        anchors { left: parent.left; leftMargin: Theme.size.padding; right: actions.left; rightMargin: Theme.size.spacing; verticalCenter: actions.verticalCenter }
        Label {
            objectName: "stopQuestionTitle"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.body
            text: Stops.keys.groupText.length > 0 ? Stops.keys.groupText : qsTr("Why is the machine stopped?")
            font { pixelSize: Theme.size.title; bold: true }
        }
        Label {
            objectName: "stopQuestionSince"
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Stops.sinceText
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Row {
        id: actions
        anchors { right: parent.right; top: parent.top; margins: Theme.size.spacing }
        spacing: Theme.size.spacing
        Button {
            objectName: "stopQuestionBack"
            visible: Stops.keys.groupText.length > 0
            glyph: Theme.icon.previous
            text: qsTr("Back")
            onClicked: Stops.keys.close()
        }
        Button {
            objectName: "stopQuestionShift"
            visible: Stops.keys.groupText.length === 0
            glyph: Theme.icon.pause
            text: qsTr("Stops")
            onClicked: Frame.openPage("stops")
        }
        Button {
            objectName: "stopQuestionLater"
            text: qsTr("Later")
            onClicked: Stops.postpone()
        }
    }
    ReasonGrid {
        anchors { left: parent.left; right: parent.right; top: actions.bottom; bottom: parent.bottom; margins: Theme.size.spacing }
        keys: Stops.keys
    }
}
