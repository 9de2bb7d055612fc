// SPDX-License-Identifier: Apache-2.0
// A horizontal dimension line of a drawing with its letter in the middle.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: dimension

    property alias letter: mark.letter
    property bool marked
    readonly property color ink: marked ? Theme.color.touch : Theme.color.secondaryInk

    implicitHeight: mark.height

    Rectangle {
        width: parent.width
        height: dimension.marked ? Theme.size.outline : Theme.size.hairline
        anchors.verticalCenter: parent.verticalCenter
        color: dimension.ink
    }
    Repeater {
        model: 2
        Rectangle {
            required property int index
            x: index * (dimension.width - width)
            width: dimension.marked ? Theme.size.outline : Theme.size.hairline
            height: parent.height
            color: dimension.ink
        }
    }
    DrawingMark {
        id: mark
        anchors.centerIn: parent
        visible: letter.length > 0
        letter: ""
        marked: dimension.marked
    }
}
