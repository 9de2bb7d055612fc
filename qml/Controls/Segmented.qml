// SPDX-License-Identifier: Apache-2.0
// A row of choices with at most one selected. Each choice is {key, text, glyph, note, name}; tests find it by the name. New texts
// for the same number of choices keep the keys, also during a touch.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    id: segmented

    required property var choices
    required property var current
    property int level                     // of the person who may choose; 0: everybody
    property bool stacked                  // signs stand above small texts
    signal chosen(var key)

    implicitHeight: Theme.size.touch
    radius: Theme.size.radius
    color: Theme.color.inset
    border { width: Theme.size.hairline; color: Theme.color.line }

    Row {
        anchors.fill: parent
        Repeater {
            model: segmented.choices.length
            TouchButton {
                id: choice
                required property int index
                readonly property var entry: segmented.choices[index] ?? {}  // empty for a key being removed
                readonly property bool holds: entry.key === segmented.current
                readonly property color ink: !enabled ? Theme.color.disabledInk : holds ? Theme.color.touch : Theme.color.secondaryInk
                objectName: entry.name ?? ""
                text: entry.text ?? ""
                level: segmented.level
                width: segmented.width / segmented.choices.length
                height: segmented.height
                onClicked: segmented.chosen(entry.key)
                background: Rectangle {
                    radius: Theme.size.radius
                    color: choice.holds || choice.down ? Theme.color.touchTint : "transparent"
                    border { width: choice.holds ? Theme.size.outline : 0; color: choice.enabled ? Theme.color.touch : Theme.color.disabledInk }
                }
                Item {
                    anchors.fill: parent
                    Grid {
                        anchors.centerIn: parent
                        columns: segmented.stacked || !sign.visible ? 1 : 2   // an empty column has its spacing too
                        spacing: remark.visible ? 0 : segmented.stacked ? Theme.size.accent : Theme.size.spacing
                        horizontalItemAlignment: Grid.AlignHCenter
                        verticalItemAlignment: Grid.AlignVCenter
                        IconLabel {
                            id: sign
                            visible: code.length > 0
                            code: choice.entry.glyph ?? ""
                            font.pixelSize: remark.visible ? Theme.size.title : Theme.size.icon
                            color: choice.ink
                        }
                        Label {
                            visible: text.length > 0
                            width: Math.min(implicitWidth, choice.width - Theme.size.accent - (sign.visible && !segmented.stacked ? sign.width + Theme.size.spacing : 0))
                            fontSizeMode: Text.HorizontalFit
                            text: choice.text
                            color: choice.ink
                            font { pixelSize: segmented.stacked ? Theme.size.caption : Theme.size.body; weight: choice.holds ? Font.Bold : Font.DemiBold }
                        }
                        Label {
                            id: remark
                            visible: segmented.stacked && text.length > 0
                            width: Math.min(implicitWidth, choice.width - Theme.size.accent)
                            fontSizeMode: Text.HorizontalFit
                            text: choice.entry.note ?? ""
                            color: choice.ink
                            font.pixelSize: Theme.size.caption
                        }
                    }
                }
            }
        }
    }
}
