// SPDX-License-Identifier: Apache-2.0
// The strokes of a press, newest first; a bad one has an icon, a color and its reason.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Card {
    id: card

    component Cell: Label {
        width: list.width * 0.3
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
        font.pixelSize: Theme.size.caption
    }

    Row {
        id: head
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding; topMargin: Theme.size.spacing }
        Cell {
            horizontalAlignment: Text.AlignLeft
            text: qsTr("Stroke")
            color: Theme.color.secondaryInk
        }
        Cell {
            text: qsTr("Error %1").arg(Theme.shownUnit("mm"))
            color: Theme.color.secondaryInk
        }
        Cell {
            text: qsTr("Force N")
            color: Theme.color.secondaryInk
        }
    }
    ListView {
        id: list
        objectName: "strokeList"
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: parent.bottom; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.accent; bottomMargin: Theme.size.spacing }
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: Controller.strokes.rows
        delegate: Item {
            id: stroke
            required property int index
            required property real number
            required property string resultText
            required property bool good
            required property string stopErrorText
            required property string stopForceText
            objectName: "stroke" + index
            width: list.width
            height: lines.height + Theme.size.spacing
            Rectangle {
                width: parent.width
                height: Theme.size.hairline
                color: Theme.color.line
            }
            Column {
                id: lines
                anchors.verticalCenter: parent.verticalCenter
                Row {
                    Cell {
                        horizontalAlignment: Text.AlignLeft
                        text: Theme.count(stroke.number, 0)
                    }
                    Cell { text: stroke.stopErrorText }
                    Cell { text: stroke.stopForceText }
                }
                Row {
                    spacing: Theme.size.spacing
                    IconLabel {
                        id: mark
                        visible: !stroke.good
                        code: Theme.icon.alert
                        color: Controller.fresh ? Theme.color.fault : Theme.color.disabledInk
                        font.pixelSize: Theme.size.body
                    }
                    Label {
                        width: list.width * 0.9 - (mark.visible ? mark.width + Theme.size.spacing : 0)
                        fontSizeMode: Text.HorizontalFit
                        text: stroke.resultText
                        color: !Controller.fresh ? Theme.color.disabledInk : stroke.good ? Theme.color.secondaryInk : Theme.color.fault
                        font { pixelSize: Theme.size.caption; weight: stroke.good ? Font.Normal : Font.DemiBold }
                    }
                }
            }
        }
    }
    ScrollMark { view: list }
    Label {
        anchors { left: list.left; right: list.right; verticalCenter: list.verticalCenter }
        visible: Controller.strokes.rows.count === 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: qsTr("Completed strokes are listed here.")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
}
