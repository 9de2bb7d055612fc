// SPDX-License-Identifier: Apache-2.0
// The packer with its panel and its controller. The part that a step of the first start is about is in the color of what is
// touched.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts

Item {
    id: picture

    property string lit                    // "panel", "plug", "key", "machine" or "bag"
    property string fieldId                // of the machine
    property bool small                    // the machine or the bag alone

    readonly property real upper: small ? 0 : Math.min(Theme.size.touch, 0.3 * height)
    readonly property real boxWidth: 0.32 * width

    component Box: DrawingPart {
        id: box
        property string name
        property string sign               // in place of the name while it is marked
        width: picture.boxWidth
        height: picture.upper
        visible: !picture.small
        Label {
            anchors { fill: parent; margins: Theme.size.accent }
            visible: !sign.visible
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
            fontSizeMode: Text.HorizontalFit
            text: box.name
            color: box.marked ? Theme.color.touch : Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        IconLabel {
            id: sign
            anchors.centerIn: parent
            visible: box.marked && box.sign.length > 0
            code: box.sign
            color: Theme.color.touch
        }
    }

    Box {
        id: controller
        name: qsTr("Controller")
        marked: picture.lit === "plug"
    }
    Rectangle {
        id: line
        x: controller.width
        y: picture.upper / 2 - height / 2
        width: panel.x - x
        height: Theme.size.accent
        visible: !picture.small
        color: picture.lit === "plug" ? Theme.color.touch : Theme.color.target
    }
    Rectangle { // the plug of the line
        anchors.centerIn: line
        width: plug.width + 2 * Theme.size.spacing
        height: width
        radius: width / 2
        visible: !picture.small
        color: picture.lit === "plug" ? Theme.color.touch : Theme.color.surface
        border { width: Theme.size.outline; color: line.color }
        IconLabel {
            id: plug
            anchors.centerIn: parent
            code: Theme.icon.serialPort
            color: picture.lit === "plug" ? Theme.color.touchInk : Theme.color.secondaryInk
        }
    }
    Box {
        id: panel
        x: picture.width - width
        name: qsTr("Panel")
        sign: picture.lit === "key" ? Theme.icon.key : Theme.icon.language
        marked: picture.lit === "panel" || picture.lit === "key"
    }
    Rectangle { // from the controller to the motor, which hides its end
        x: 0.08 * picture.width
        y: picture.upper
        width: Theme.size.accent
        height: lower.y + 0.45 * lower.height - y
        visible: !picture.small && !bag.visible
        color: Theme.color.target
    }
    Item {
        id: lower
        anchors { left: parent.left; right: parent.right; top: parent.top; topMargin: picture.small ? 0 : picture.upper + Theme.size.padding; bottom: parent.bottom }
        BagDrawing {
            id: bag
            anchors.fill: parent
            visible: picture.lit === "bag"
        }
        MachineDrawing {
            // Its dimension lies below its film.
            width: parent.width
            height: Math.min(parent.height, (parent.height - 3 * Theme.size.accent - 1.5 * Theme.size.body) / 0.76)
            visible: !bag.visible
            fieldId: picture.fieldId
        }
    }
}
