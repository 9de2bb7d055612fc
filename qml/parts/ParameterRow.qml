// SPDX-License-Identifier: Apache-2.0
// One parameter of the controller: name and range, value or choices, and a key to use a suggestion.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    id: row

    required property int index
    required property int neededLevel
    required property string name
    required note
    required property string value
    required property string unit
    required property var choices          // texts; empty for a number
    required property int choice
    required property bool known
    required property string suggestion
    required property bool measurable
    signal chosen(int choice)
    signal suggestionTaken()
    signal measureRequested()

    readonly property bool toggle: row.choices.length > 0

    enabled: row.known
    tappable: !row.toggle
    text: row.name
    rightPadding: Theme.size.padding + (row.toggle ? keys.width : shown.width + (take.visible ? take.width + Theme.size.spacing : 0))
        + (measure.visible ? measure.width + Theme.size.spacing : 0)
    noteLabel { wrapMode: Text.WordWrap; fontSizeMode: Text.FixedSize; maximumLineCount: 2 }
    level: row.toggle ? 0 : row.neededLevel

    Button {
        id: take
        objectName: row.objectName + "take"
        level: row.neededLevel
        anchors { right: shown.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: row.suggestion.length > 0
        text: qsTr("Apply %1").arg(row.suggestion)
        onClicked: row.suggestionTaken()
    }
    Button {
        id: measure
        objectName: row.objectName + "measure"
        anchors { right: row.toggle ? keys.left : shown.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: row.measurable
        text: qsTr("Measure")
        onClicked: row.measureRequested()
    }
    Readout {
        id: shown
        anchors { right: row.arrow.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: !row.toggle
        text: row.value
        unit: row.unit
        pixelSize: Theme.size.title
        stale: !row.known
    }
    Segmented {
        id: keys
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        visible: row.toggle
        level: row.neededLevel
        width: Math.round(Math.max(parent.width * 0.15, Theme.size.touch) * Math.max(2, row.choices.length))
        choices: row.choices.map((text, key) => ({ key: key, text: text, name: row.objectName + "choice" + key }))
        current: row.choice
        onChosen: key => row.chosen(key)
    }
}
