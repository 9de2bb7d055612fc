// SPDX-License-Identifier: Apache-2.0
// One parameter of the controller: name and range, value or choices, and a key to use a suggestion.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

TouchButton {
    id: row
    Accessible.name: row.name

    required property int index
    required property string name
    required property string note
    required property string value
    required property string unit
    required property var choices          // texts; empty for a number
    required property int choice
    required property bool known
    required property string suggestion
    signal chosen(int choice)
    signal suggestionTaken()

    readonly property bool toggle: row.choices.length > 0

    implicitHeight: Theme.size.touch
    enabled: row.known

    background: Rectangle {
        radius: Theme.size.radius
        color: row.down && !row.toggle ? Theme.color.touchTint : Theme.color.inset
        border { width: Theme.size.hairline; color: Theme.color.line }
    }
    Item {
        anchors.fill: parent
        Column {
            anchors { left: parent.left; right: row.toggle ? keys.left : take.visible ? take.left : shown.left; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
            Label {
                width: parent.width
                text: row.name
                fontSizeMode: Text.HorizontalFit
                font.weight: Font.DemiBold
            }
            Label {
                width: parent.width
                visible: row.note.length > 0
                text: row.note
                wrapMode: Text.WordWrap
                maximumLineCount: 2
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption - 2
            }
        }
        Button {
            id: take
            objectName: row.objectName + "take"
            level: row.level
            anchors { right: shown.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            visible: row.suggestion.length > 0
            text: qsTr("Apply %1").arg(row.suggestion)
            onClicked: row.suggestionTaken()
        }
        Readout {
            id: shown
            anchors { right: mark.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            visible: !row.toggle
            text: row.value
            unit: row.unit
            pixelSize: Theme.size.title
            stale: !row.known
        }
        IconLabel {
            id: mark
            anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            visible: !row.toggle
            code: Theme.icon.edit
            color: row.known ? Theme.color.touch : Theme.color.disabledInk
        }
        Segmented {
            id: keys
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            visible: row.toggle
            level: row.level
            width: Math.round(Math.max(parent.width * 0.15, Theme.size.touch) * Math.max(2, row.choices.length))
            choices: row.choices.map((text, key) => ({ key: key, text: text, name: row.objectName + "choice" + key }))
            current: row.choice
            onChosen: key => row.chosen(key)
        }
    }
}
