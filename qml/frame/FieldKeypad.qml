// SPDX-License-Identifier: Apache-2.0
// The keypad for one number, or for several with a strip of tabs on the left with their values.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: editor

    required property var fields           // list of Value
    required property int index
    required property string heading
    required property string warning
    readonly property Value field: fields[index]
    readonly property bool several: fields.length > 1
    readonly property real stripWidth: several ? strip.width + Theme.size.spacing : 0
    readonly property real minWidth: 4 * Theme.size.touch + 2 * Theme.size.accent + stripWidth
    property alias pending: pad.pending
    property alias ready: pad.acceptable
    signal edited()
    signal closed()

    // Sets the field to a valid number; the keypad is empty then.
    function take(): void {
        if (!pad.acceptable || !Access.ask(editor.field.neededLevel))
            return
        const number = pad.typedValue
        pad.clear()
        editor.field.set(number)
    }
    function openTab(index: int): void {
        editor.take()
        if (!pad.pending)
            editor.index = index
    }

    implicitWidth: Theme.size.keypad + stripWidth

    Rectangle { // nothing looks out above, below and between the tabs
        anchors.fill: parent
        color: Theme.color.ground
        MouseArea { anchors.fill: parent }
    }
    Column {
        id: strip
        visible: editor.several
        width: Theme.size.touch + Theme.size.padding
        anchors { left: parent.left; top: pad.top; bottom: pad.bottom }
        spacing: Theme.size.spacing
        Repeater {
            model: editor.several ? editor.fields.length : 0
            TouchButton {
                id: tab
                Accessible.name: tab.field.label
                required property int index
                objectName: "keypadTab" + index
                readonly property Value field: editor.fields[index]
                readonly property bool holds: index === editor.index
                width: strip.width
                height: (strip.height - (editor.fields.length - 1) * strip.spacing) / editor.fields.length
                onClicked: editor.openTab(tab.index)
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
        width: editor.width - editor.stripWidth
        height: Math.min(parent.height, preferredHeight)
        label: editor.heading.length > 0 ? editor.heading : editor.field.label
        unit: editor.field.unit
        level: editor.field.neededLevel
        currentText: editor.field.text
        minimum: editor.field.minimum
        maximum: editor.field.maximum
        possible: editor.field.possible
        defaultValue: editor.field.defaultValue
        decimals: editor.field.decimals
        refusal: isNaN(typedValue) ? "" : editor.field.check(typedValue)
        warning: editor.warning
        onEdited: editor.edited()
        onAccepted: {
            editor.take()
            if (!pad.pending)
                editor.closed()
        }
        onCanceled: editor.closed()
    }
}
