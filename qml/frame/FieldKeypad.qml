// SPDX-License-Identifier: Apache-2.0
// The keypad for one field, or for several with a strip of tabs on the left with their values.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: editor

    required property var fields           // list of EditorField
    required property int index
    readonly property EditorField field: fields[index]
    readonly property bool several: fields.length > 1
    signal closed()

    implicitWidth: Theme.size.keypad + (several ? strip.width + Theme.size.spacing : 0)

    Column {
        id: strip
        visible: editor.several
        width: Theme.size.touch + Theme.size.padding
        anchors { left: parent.left; top: pad.top; bottom: pad.bottom }
        spacing: Theme.size.spacing
        Repeater {
            model: editor.several ? editor.fields.length : 0
            T.AbstractButton {
                id: tab
                Accessible.role: Accessible.Button
                Accessible.name: tab.field.label
                required property int index
                readonly property EditorField field: editor.fields[index]
                readonly property bool holds: index === editor.index
                width: strip.width
                height: (strip.height - (editor.fields.length - 1) * strip.spacing) / editor.fields.length
                onClicked: editor.index = tab.index
                background: Card {
                    color: tab.holds ? Theme.color.touchTint : Theme.color.surface
                    border { width: tab.holds ? Theme.size.outline : Theme.size.hairline; color: tab.holds ? Theme.color.touch : Theme.color.line }
                }
                Column {
                    anchors.centerIn: parent
                    Label {
                        anchors.horizontalCenter: parent.horizontalCenter
                        text: tab.field.label
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                    Label {
                        anchors.horizontalCenter: parent.horizontalCenter
                        text: tab.field.text
                        font { pixelSize: Theme.size.title; bold: true }
                    }
                }
            }
        }
    }
    NumericKeypad {
        id: pad
        objectName: "keypad"
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        width: Theme.size.keypad
        height: Math.min(parent.height, preferredHeight)
        label: editor.field.label
        unit: editor.field.unit
        currentText: editor.field.text
        minimum: editor.field.minimum
        maximum: editor.field.maximum
        defaultValue: editor.field.defaultValue
        decimals: editor.field.decimals
        refusal: isNaN(typedValue) ? "" : editor.field.check(typedValue)
        onAccepted: value => {
            editor.field.set(value)
            editor.closed()
        }
        onCanceled: editor.closed()
    }
}
