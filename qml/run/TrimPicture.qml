// SPDX-License-Identifier: Apache-2.0
// A bag between two cuts with its product, where the program has them as outlines, and where the trims move them. The film
// runs to the right, as on Run; the shifts are drawn larger than they are.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: picture

    required property var mm               // of cut, product and length
    property bool stale

    readonly property real bag: width * 0.56
    readonly property real perMm: bag * 0.012
    readonly property real leftCut: (width - bag) / 2 - picture.mm[0] * perMm - picture.mm[2] * perMm
    readonly property real rightCut: (width + bag) / 2 - picture.mm[0] * perMm
    readonly property real middle: (width - picture.mm[2] * perMm) / 2 - picture.mm[0] * perMm + picture.mm[1] * perMm
    readonly property color ink: stale ? Theme.color.disabledInk : Theme.color.ink

    component Cut: Rectangle {
        property bool nominal
        width: nominal ? Theme.size.hairline : Theme.size.outline
        height: picture.height
        color: nominal ? Theme.color.target : picture.ink
    }

    Rectangle {
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        height: 2 * Math.round(parent.height * 0.36)
        color: picture.stale ? Theme.color.inset : Theme.color.touchTint
        border { width: Theme.size.hairline; color: Theme.color.target }
    }
    Rectangle {
        anchors { horizontalCenter: parent.horizontalCenter; verticalCenter: parent.verticalCenter }
        width: picture.bag * 0.6
        height: 2 * Math.round(parent.height * 0.22)
        color: "transparent"
        border { width: Theme.size.hairline; color: Theme.color.target }
    }
    Cut { nominal: true; x: (picture.width - picture.bag) / 2 }
    Cut { nominal: true; x: (picture.width + picture.bag) / 2 }
    Rectangle {
        x: picture.middle - width / 2
        anchors.verticalCenter: parent.verticalCenter
        width: picture.bag * 0.6
        height: 2 * Math.round(parent.height * 0.2)
        radius: Theme.size.accent
        color: picture.stale ? Theme.color.disabledInk : Theme.color.sync
    }
    Cut { x: picture.leftCut }
    Cut { x: picture.rightCut }
    IconLabel {
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        code: Theme.icon.jogForward
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.title
    }
}
