// SPDX-License-Identifier: Apache-2.0
// Cut, product and length of the bags that are being made: a step left or right on the film, back to 0, and saved with the
// recipe. It stays open, for the next step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    objectName: "trimSheet"
    title: qsTr("Trim the bags")
    note: HandTrims.message || qsTr("The next bags follow. Each touch moves by %1; hold a key to repeat.").arg(HandTrims.stepText)

    header: [
        Button {
            objectName: "trimSave"
            level: Access.Operator
            glyph: Theme.icon.save
            text: qsTr("Save with recipe")
            enabled: HandTrims.offered
            onClicked: HandTrims.save()
        }
    ]

    TrimPicture {
        id: picture
        objectName: "trimPicture"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; verticalCenterOffset: -(lines.height + Theme.size.padding) / 2 }
        height: Math.min(3 * Theme.size.touch, lines.y - Theme.size.padding)
        mm: HandTrims.mm
        stale: !Controller.fresh
    }
    Column {
        id: lines
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.spacing
        Repeater {
            model: HandTrims.rows
            Item {
                id: line
                required property int trim
                required property string title
                required property string amount
                required property string note
                required property string leftText
                required property string rightText
                required property bool canLeft
                required property bool canRight
                required property bool canReset
                readonly property real keyWidth: Math.round(sheet.width * 0.2)
                width: lines.width
                height: Theme.size.touch
                Column {
                    anchors { left: parent.left; right: leftKey.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
                    Label {
                        width: parent.width
                        fontSizeMode: Text.HorizontalFit
                        text: line.title
                        color: Theme.color.secondaryInk
                        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
                    }
                    Label {
                        objectName: "trimAmount" + line.trim
                        width: parent.width
                        fontSizeMode: Text.HorizontalFit
                        text: line.amount
                        color: !Controller.fresh ? Theme.color.disabledInk : line.canReset ? Theme.color.warning : Theme.color.ink
                        font { pixelSize: Theme.size.title; weight: Font.DemiBold }
                    }
                    Label {
                        objectName: "trimNote" + line.trim
                        visible: text.length > 0
                        width: parent.width
                        fontSizeMode: Text.HorizontalFit
                        text: line.note
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                }
                StepButton {
                    id: leftKey
                    objectName: "trimLeft" + line.trim
                    anchors { right: resetKey.left; rightMargin: Theme.size.spacing }
                    width: line.keyWidth
                    level: Access.Operator
                    glyph: Theme.icon.jogReverse
                    text: line.leftText
                    enabled: line.canLeft
                    onClicked: HandTrims.left(line.trim)
                }
                Button {
                    id: resetKey
                    objectName: "trimReset" + line.trim
                    Accessible.name: qsTr("%1 back to 0").arg(line.title)
                    anchors { right: rightKey.left; rightMargin: Theme.size.spacing }
                    width: Theme.size.touch
                    level: Access.Operator
                    text: "0"
                    enabled: line.canReset
                    onClicked: HandTrims.reset(line.trim)
                }
                StepButton {
                    id: rightKey
                    objectName: "trimRight" + line.trim
                    anchors.right: parent.right
                    width: line.keyWidth
                    level: Access.Operator
                    glyph: Theme.icon.jogForward
                    text: line.rightText
                    enabled: line.canRight
                    onClicked: HandTrims.right(line.trim)
                }
            }
        }
    }
}
