// SPDX-License-Identifier: Apache-2.0
// The filter of the list below, with the key that ends it: nobody takes a filtered list for the whole.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Rectangle {
    id: strip

    required property LogFilter filter
    property bool shown: true

    visible: strip.shown && strip.filter.active
    height: Theme.size.touch
    radius: Theme.size.radius
    color: Theme.color.touchTint
    border { width: Theme.size.outline; color: Theme.color.touch }

    IconLabel {
        id: mark
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
        code: Theme.icon.filter
        color: Theme.color.touch
    }
    Label {
        objectName: "filterSummary"
        anchors { left: mark.right; right: clear.left; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
        text: qsTr("Only: %1").arg(strip.filter.summary)
        fontSizeMode: Text.HorizontalFit
        font.weight: Font.DemiBold
    }
    Button {
        id: clear
        objectName: "filterClear"
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        kind: Button.Quiet
        glyph: Theme.icon.close
        text: qsTr("Show all")
        onClicked: strip.filter.clear()
    }
}
