// SPDX-License-Identifier: Apache-2.0
// One live value below its name; gray when it is old.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Rectangle {
    id: tile

    required property string label
    required property string value
    property bool stale

    implicitHeight: Theme.size.touch
    radius: Theme.size.radius
    color: Theme.color.surface
    border { width: Theme.size.hairline; color: Theme.color.line }

    Label {
        anchors { left: parent.left; right: parent.right; top: parent.top; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        text: tile.label
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 2
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; bottomMargin: Theme.size.spacing }
        text: tile.value
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 2
        color: tile.stale ? Theme.color.disabledInk : Theme.color.ink
        font { pixelSize: Theme.size.title; weight: Font.DemiBold }
    }
}
