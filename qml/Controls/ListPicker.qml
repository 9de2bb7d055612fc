// SPDX-License-Identifier: Apache-2.0
// A sheet with a list and one selected entry; each choice is {key, text, note, glyph}. A choice closes it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Sheet {
    id: picker

    required property var choices
    required property var current
    property string emptyText
    property alias delegate: list.delegate
    property int level                     // of the person who may choose; 0: everybody
    property bool stays                    // open after a choice
    signal chosen(var key)

    function choose(key: var): void {
        const closes = !picker.stays
        picker.chosen(key)
        if (closes)
            picker.closed()
    }

    panelHeight: Theme.size.touch + Theme.size.padding + Math.max(1, picker.choices.length) * (Theme.size.touch + Theme.size.spacing)
    panelWidth: Math.round(width * 0.62)

    Label {
        anchors.fill: parent
        visible: picker.choices.length === 0
        wrapMode: Text.WordWrap
        text: picker.emptyText
        color: Theme.color.secondaryInk
    }
    ListView {
        id: list
        anchors.fill: parent
        clip: true
        model: picker.choices
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        delegate: ChoiceRow {
            required property var modelData
            objectName: "choice_" + modelData.key
            level: picker.level
            text: modelData.text
            note: modelData.note ?? ""
            glyph: modelData.glyph ?? ""
            holds: modelData.key === picker.current
            onClicked: picker.choose(modelData.key)
        }
    }
    ScrollMark { view: list }
}
