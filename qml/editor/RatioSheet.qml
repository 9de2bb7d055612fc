// SPDX-License-Identifier: Apache-2.0
// The ratios beside the curve: keys that let them suit the machine, a slider between, what they demand, the four numbers and
// the window.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Parts

Sheet {
    id: sheet

    readonly property var ratios: Array.from(["k1", "k2", "k3", "k4"], name => Editor.field(name))

    objectName: "ratioSheet"
    beside: true
    title: qsTr("Ratios")
    note: Editor.cutter.ramps.stateText
    // Three keys beside each other, also with gloves.
    panelWidth: Math.max(besideWidth, 3 * Theme.size.touch + 2 * Theme.size.padding + 3 * Theme.size.accent)
    panelHeight: height

    Flickable {
        id: list
        anchors.fill: parent
        clip: true
        contentWidth: width
        contentHeight: rows.height
        boundsBehavior: Flickable.StopAtBounds
        interactive: scrolls && !slider.pressed
        readonly property bool scrolls: contentHeight > height

        Column {
            id: rows
            width: list.width - (list.scrolls ? 2 * Theme.size.accent : 0)
            spacing: Theme.size.outline

            Segmented {
                readonly property list<string> lowered: [...Editor.cutter.ramps.presets]   // motor speed, heat, jolt
                width: parent.width
                stacked: true
                level: Access.Technician
                choices: [
                    { key: RampControl.Slow, text: qsTr("Slow"), glyph: Theme.icon.speed, note: lowered[0], name: "ratioSlow" },
                    { key: RampControl.Cool, text: qsTr("Cool"), glyph: Theme.icon.heat, note: lowered[1], name: "ratioCool" },
                    { key: RampControl.Gentle, text: qsTr("Gentle"), glyph: Theme.icon.jolt, note: lowered[2], name: "ratioGentle" }
                ]
                current: Editor.cutter.ramps.mode
                onChosen: key => Editor.cutter.ramps.choose(key)
            }
            Slider {
                id: slider
                objectName: "ratioSlider"
                level: Access.Technician
                Accessible.name: sheet.title
                width: parent.width
                from: 0
                to: 100
                known: !isNaN(Editor.cutter.ramps.position)
                enabled: known
                onHeld: value => Editor.cutter.ramps.drag(value)
                onReleased: Editor.cutter.ramps.endDrag()
                Binding {
                    target: slider
                    property: "value"
                    value: Editor.cutter.ramps.position
                    when: slider.known && !slider.pressed
                    restoreMode: Binding.RestoreNone
                }
            }
            Item {
                objectName: "ratioFigures"
                width: parent.width
                height: figures.height
                Column {
                    id: figures
                    width: parent.width
                    spacing: Theme.size.outline
                    Repeater {
                        model: Editor.cutter.ramps.figures
                        Item {
                            id: figure
                            required property string label
                            required property string value
                            width: figures.width
                            height: name.height
                            Label {
                                id: name
                                width: parent.width * 0.55
                                fontSizeMode: Text.HorizontalFit
                                text: figure.label
                                color: Theme.color.secondaryInk
                                font.pixelSize: Theme.size.caption
                            }
                            Label {
                                anchors { right: parent.right; baseline: name.baseline }
                                width: parent.width * 0.45
                                horizontalAlignment: Text.AlignRight
                                fontSizeMode: Text.HorizontalFit
                                text: figure.value
                                font { pixelSize: Theme.size.body; bold: true }
                            }
                        }
                    }
                }
                Explained {
                    explained: () => Explanations.ofVerdict()
                }
            }
            RatioGroup {
                id: group
                objectName: "ratioNumbers"
                level: sheet.ratios[0].neededLevel
                width: parent.width
                fields: sheet.ratios
                onClicked: Frame.edit(sheet.ratios, group.nearest, group, "")
            }
            Row {
                width: parent.width
                Button {
                    objectName: "windowNarrower"
                    level: Access.Technician
                    width: Theme.size.touch
                    text: "\u2212"
                    onClicked: Editor.cutter.ramps.narrowWindow()
                }
                Column {
                    width: parent.width - 2 * Theme.size.touch
                    anchors.verticalCenter: parent.verticalCenter
                    Label {
                        width: parent.width
                        horizontalAlignment: Text.AlignHCenter
                        fontSizeMode: Text.HorizontalFit
                        text: qsTr("Sealing window")
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                    Label {
                        objectName: "windowText"
                        width: parent.width
                        horizontalAlignment: Text.AlignHCenter
                        text: Editor.cutter.ramps.windowText
                        font { pixelSize: Theme.size.body; bold: true }
                    }
                }
                Button {
                    objectName: "windowWider"
                    level: Access.Technician
                    width: Theme.size.touch
                    text: "+"
                    onClicked: Editor.cutter.ramps.widenWindow()
                }
            }
        }
    }
    ScrollMark { view: list }
}
