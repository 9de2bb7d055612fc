// SPDX-License-Identifier: Apache-2.0
// The speed of the film while the running machine changes its program, as a line over time: how slow it gets, and for how long.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: picture

    required property var speeds           // corners in seconds and per cent of the speed before; empty: it goes on

    readonly property bool flat: speeds.length < 3
    readonly property real span: flat ? 1 : speeds[2].x
    readonly property real least: flat ? 100 : speeds[1].y
    readonly property real most: flat ? 100 : Math.max(100, speeds[2].y)
    readonly property real lead: Math.round(width / 5)   // on both sides, at constant speed
    readonly property real lower: base.y
    readonly property list<point> corners: speeds.length < 3 ? [Qt.point(0, placeOf(100)), Qt.point(width, placeOf(100))]
        : [Qt.point(0, placeOf(100)), Qt.point(lead, placeOf(100)), Qt.point(lead + (width - 2 * lead) * speeds[1].x / span, placeOf(speeds[1].y)),
           Qt.point(width - lead, placeOf(speeds[2].y)), Qt.point(width, placeOf(speeds[2].y))]

    function placeOf(percent: real): real { return top.height + (picture.lower - top.height) * (1 - percent / picture.most) }

    Label {
        id: top
        text: "100 %"
        y: Math.max(0, picture.placeOf(100) - height)
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Rectangle {
        id: base
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; bottomMargin: slowest.visible ? slowest.height : 0 }
        height: Theme.size.hairline
        color: Theme.color.line
    }
    Repeater {
        model: picture.corners.length - 1
        Rectangle {
            required property int index
            readonly property point from: picture.corners[index]
            readonly property point to: picture.corners[index + 1]
            x: from.x
            y: from.y - height / 2
            width: Math.hypot(to.x - from.x, to.y - from.y)
            height: Theme.size.curve
            radius: height / 2
            antialiasing: true
            color: Theme.color.touch
            transformOrigin: Item.Left
            rotation: Math.atan2(to.y - from.y, to.x - from.x) * 180 / Math.PI
        }
    }
    Label {
        id: slowest
        objectName: "changeSlowest"
        visible: picture.height > 5 * Theme.size.body   // the line needs the room more: the sentence says it too
        anchors { bottom: parent.bottom; horizontalCenter: parent.horizontalCenter }
        text: picture.flat ? qsTr("The film keeps its speed.") : Theme.fill(qsTr("down to %1 for %2"), [Theme.joined(Theme.number(picture.least, 0), "%"), Theme.joined(Theme.number(picture.span, 1), "s")])
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
}
