// SPDX-License-Identifier: Apache-2.0
// The operator's hand on the bags: cut, product and length a step left or right on the film, back to 0, and saved with the
// recipe; one bag, one cut, the next bag for a person. It stays open, for the next step.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    objectName: "trimSheet"
    property BagKey refused: null          // the key of a single bag that was touched last, where it does nothing
    title: qsTr("By hand")
    note: HandTrims.message || (refused ? refused.reason : "") || HandBags.message || (HandTrims.unsaved ? qsTr("The next bags follow. Not saved with the recipe.") : qsTr("The next bags follow. Each touch moves by %1; hold a key to repeat.").arg(HandTrims.stepText))

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

    Row {
        id: keys
        visible: HandBags.offered
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: visible ? Theme.size.touch : 0
        spacing: Theme.size.spacing
        BagKey {
            objectName: "bagKey"
            glyph: Theme.icon.start
            text: qsTr("One bag")
            reason: HandBags.bagReason
            onCommanded: HandBags.makeBag()
        }
        BagKey {
            objectName: "cutKey"
            glyph: Theme.icon.cut
            text: qsTr("Single cut")
            reason: HandBags.cutReason
            onCommanded: HandBags.cut()
        }
        BagKey {
            objectName: "takeKey"
            glyph: Theme.icon.user
            text: qsTr("Next bag to me")
            holdMs: 0
            reason: HandBags.takeReason
            onCommanded: HandBags.take()
        }
    }

    component BagKey: CommandButton {
        id: bagKey
        required property string glyph
        required property string reason    // why it does nothing now
        readonly property color inkColor: ready && !locked ? Theme.color.touch : Theme.color.secondaryInk
        width: Math.floor((keys.width - 2 * keys.spacing) / 3)
        height: keys.height
        level: Access.Operator
        ready: reason.length === 0
        ringHost: sign
        ringColor: inkColor
        onRefused: sheet.refused = bagKey
        onCommanded: sheet.refused = null
        background: Rectangle {
            radius: Theme.size.radius
            color: bagKey.down || !bagKey.ready ? Theme.color.inset : Theme.color.surface
            border { width: Theme.size.outline; color: bagKey.ready && !bagKey.locked ? Theme.color.touch : Theme.color.line }
        }
        Item {
            anchors { fill: parent; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding }
            IconLabel {
                id: sign
                anchors.verticalCenter: parent.verticalCenter
                code: bagKey.glyph
                color: bagKey.inkColor
                font.pixelSize: Theme.size.icon
            }
            Column {
                anchors { left: sign.right; leftMargin: Theme.size.padding; right: parent.right; verticalCenter: parent.verticalCenter }
                Label {
                    width: parent.width
                    fontSizeMode: Text.HorizontalFit
                    text: bagKey.text
                    color: bagKey.inkColor
                    font { pixelSize: Theme.size.body; bold: true }
                }
                Label {
                    width: parent.width
                    visible: text.length > 0
                    fontSizeMode: Text.HorizontalFit
                    text: bagKey.holdNote
                    color: bagKey.inkColor
                    font.pixelSize: Theme.size.caption
                }
            }
        }
    }

    TrimPicture {
        id: picture
        objectName: "trimPicture"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; verticalCenterOffset: -(parent.height - lines.y + Theme.size.padding) / 2 }
        height: Math.min(3 * Theme.size.touch, lines.y - Theme.size.padding)
        visible: height > Theme.size.touch / 2 // gloves on the smallest screen leave it no room
        mm: HandTrims.mm
        stale: !Controller.fresh
    }
    Column {
        id: lines
        anchors { left: parent.left; right: parent.right; bottom: keys.top; bottomMargin: keys.visible ? Theme.size.padding : 0 }
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
