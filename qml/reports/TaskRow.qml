// SPDX-License-Identifier: Apache-2.0
// An action with a sentence about its effect, and its key.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: row

    required property string title
    required property string note
    required property string action
    required property string name          // name of the key for tests
    property int level                     // of the person who may press its key; 0: everybody
    property string glyph
    property real keyWidth: key.implicitWidth
    readonly property alias naturalKeyWidth: key.implicitWidth
    property bool usable: true
    signal clicked()

    implicitHeight: Theme.size.touch

    Column {
        anchors { left: parent.left; right: key.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
        Label {
            id: heading
            width: parent.width
            text: row.title
            font.weight: Font.DemiBold
        }
        Label {
            width: parent.width
            height: Math.min(implicitHeight, row.height - heading.height)
            wrapMode: Text.Wrap
            fontSizeMode: Text.Fit
            text: row.note
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    Button {
        id: key
        objectName: row.name
        level: row.level
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        width: row.keyWidth
        enabled: row.usable
        glyph: row.glyph
        text: row.action
        onClicked: row.clicked()
    }
}
