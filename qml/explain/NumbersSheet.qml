// SPDX-License-Identifier: Apache-2.0
// Derived numbers explained, one below the other, with their values when the finger was held: meaning, formula, numbers,
// result.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    property var quantities: []            // list of Explanations.Quantity
    property var told: []                  // or of Explanation
    property string heading                // common heading of the numbers
    readonly property bool single: told.length === 1

    title: sheet.heading.length > 0 ? sheet.heading : sheet.single ? told[0].title : qsTr("How this is calculated")
    panelWidth: width * 0.85
    panelHeight: height * (sheet.single ? 0.75 : 0.95)
    Component.onCompleted: {
        if (quantities.length > 0)
            told = quantities.map(quantity => Explanations.of(quantity))
    }

    Flickable {
        id: list
        anchors.fill: parent
        clip: true
        contentWidth: width
        contentHeight: blocks.height
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: blocks
            width: parent.width
            spacing: Theme.size.padding
            Repeater {
                model: sheet.told
                Column {
                    id: block
                    required property var modelData
                    width: blocks.width
                    spacing: Theme.size.accent
                    Label {
                        visible: !sheet.single || sheet.heading.length > 0
                        width: parent.width
                        wrapMode: Text.WordWrap
                        text: block.modelData.title
                        font.bold: true
                    }
                    Readout {
                        width: parent.width
                        text: block.modelData.value
                        unit: block.modelData.unit
                        pixelSize: sheet.single ? Theme.size.hero : Theme.size.value
                    }
                    Label {
                        objectName: "explanationText"
                        width: parent.width
                        wrapMode: Text.WordWrap
                        text: block.modelData.text
                        lineHeight: 1.15
                    }
                }
            }
        }
    }
    ScrollMark { view: list }
}
