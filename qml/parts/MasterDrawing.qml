// SPDX-License-Identifier: Apache-2.0
// The master of the line as a drawing: the film, the knife, and the encoder on the line's shaft or as a wheel on the film.
// The hand of the encoder stands at its live angle; the numbers stand at their places.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: drawing

    required property MasterWatch master

    readonly property color ink: drawing.master.leads ? Theme.color.touch : Theme.color.target
    readonly property real filmY: Math.round(drawing.master.wheel ? height * 0.72 : Math.max(height * 0.3, knife.height + knifeName.height))

    Accessible.role: Accessible.Graphic
    Accessible.name: drawing.master.wheel ? qsTr("Encoder wheel on the film") : qsTr("Encoder on the shaft of the line")
    Accessible.description: drawing.master.stateText

    Rectangle {
        id: film
        anchors { left: parent.left; right: parent.right }
        y: drawing.filmY
        height: 2 * Theme.size.outline
        color: Theme.color.target
    }
    Rectangle {
        id: knife
        x: Math.round(parent.width * 0.86)
        y: drawing.filmY - Math.round(drawing.height * 0.22)
        width: 2 * Theme.size.outline
        height: Math.round(drawing.height * 0.22)
        color: Theme.color.ink
    }
    Label {
        id: knifeName
        anchors { horizontalCenter: knife.horizontalCenter; bottom: knife.top }
        text: qsTr("knife")
        font.pixelSize: Theme.size.caption
    }
    Label {
        anchors { left: parent.left; top: film.bottom; topMargin: Theme.size.outline }
        text: qsTr("film")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Rectangle {
        id: encoder
        readonly property int size: Math.round(Math.min(drawing.height * 0.5, drawing.width * 0.3))
        x: Math.round(drawing.width * 0.2 - size / 2)
        y: drawing.master.wheel ? drawing.filmY - size : drawing.height - size
        width: size
        height: size
        radius: size / 2
        color: "transparent"
        border { width: 2 * Theme.size.outline; color: drawing.ink }
        Item {
            anchors.fill: parent
            rotation: isNaN(drawing.master.angleDeg) ? 0 : drawing.master.angleDeg
            Rectangle {
                visible: !isNaN(drawing.master.angleDeg)
                anchors { horizontalCenter: parent.horizontalCenter; top: parent.top }
                width: 2 * Theme.size.outline
                height: parent.height / 2
                color: drawing.ink
            }
        }
    }
    Rectangle {
        id: shaft
        visible: !drawing.master.wheel
        anchors { left: encoder.right; verticalCenter: encoder.verticalCenter; right: knife.right }
        height: 2 * Theme.size.outline
        color: drawing.ink
    }
    Rectangle {
        visible: shaft.visible
        anchors { right: knife.right; top: film.bottom; bottom: shaft.bottom }
        width: 2 * Theme.size.outline
        color: drawing.ink
    }
    Column {
        id: scale
        anchors { left: encoder.right; leftMargin: Theme.size.spacing; right: knifeName.left; bottom: encoder.verticalCenter; bottomMargin: Theme.size.outline }
        Label {
            objectName: "masterCounts"
            width: parent.width
            text: drawing.master.countsText
            font.pixelSize: Theme.size.caption
        }
        Label {
            objectName: "masterRevolution"
            width: parent.width
            text: drawing.master.revolutionText
            font.pixelSize: Theme.size.caption
        }
    }
    Label {
        objectName: "masterAngle"
        anchors { left: scale.left; right: scale.right; top: encoder.verticalCenter; topMargin: 2 * Theme.size.outline }
        text: Theme.measure(drawing.master.angleDeg, 1, "°")
        font.pixelSize: Theme.size.caption
    }
}
