// SPDX-License-Identifier: Apache-2.0
// The speed over one cycle: the target of the program, and the axis in the newest cycle. Below it the torque.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    required property string title
    property bool compact                  // little space for texts
    readonly property color traceColor: Controller.fresh ? Theme.color.touch : Theme.color.disabledInk

    component Key: Row {
        id: key
        required property string text
        required property color color
        spacing: Theme.size.accent
        Rectangle {
            anchors.verticalCenter: parent.verticalCenter
            width: Theme.size.icon
            height: Theme.size.accent
            radius: height / 2
            color: key.color
        }
        Label {
            text: key.text
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }

    Label {
        id: caption
        anchors { left: parent.left; top: parent.top; leftMargin: Theme.size.padding; topMargin: Theme.size.spacing }
        width: Math.min(implicitWidth, 0.3 * card.width)
        fontSizeMode: Text.HorizontalFit
        text: card.title
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Row {
        id: keys
        anchors { right: parent.right; rightMargin: Theme.size.padding; verticalCenter: caption.verticalCenter }
        spacing: card.compact ? Theme.size.spacing : Theme.size.padding
        Label {
            objectName: "followingError"
            id: followingError
            readonly property real room: 0.7 * card.width - 3 * Theme.size.padding - target.width - actual.width - 2 * keys.spacing
            width: Math.min(implicitWidth, room)
            fontSizeMode: Text.HorizontalFit
            readonly property string number: Theme.measure(Controller.live.followingErrorMm, 2, "mm")
            text: card.compact || words.advanceWidth > followingError.room ? qsTr("error %1").arg(number) : words.text
            TextMetrics {
                id: words
                font: Theme.captionFont
                text: qsTr("following error %1").arg(followingError.number)
            }
            color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
            font.pixelSize: Theme.size.caption
        }
        Key { id: target; text: qsTr("target"); color: Theme.color.target }
        Key { id: actual; text: qsTr("actual"); color: card.traceColor }
    }
    StyledCurves {
        anchors { left: parent.left; right: parent.right; top: caption.bottom; bottom: torque.top; margins: Theme.size.spacing; topMargin: Theme.size.outline; bottomMargin: 0 }
        curves: Controller.active.curves
        quantities: ["velocity"]
        style.velocityColor: Theme.color.target
        style.lineWidth: 2 * Theme.size.curve
        trace: Controller.actualTrace
        style.traceColor: card.traceColor
        style.inkColor: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
        cursorTime: Controller.live.masterAngleDeg / 360 * Controller.active.cycleSeconds
        cursorDotsVisible: false
    }
    Label {
        id: torque
        objectName: "torqueText"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; leftMargin: Theme.size.padding; rightMargin: Theme.size.padding; bottomMargin: Theme.size.outline }
        horizontalAlignment: Text.AlignRight
        fontSizeMode: Text.HorizontalFit
        text: card.compact || torqueWords.advanceWidth > width ? Controller.torque.shortText : torqueWords.text
        TextMetrics {
            id: torqueWords
            font: Theme.captionFont
            text: Controller.torque.text
        }
        color: Controller.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk
        font.pixelSize: Theme.size.caption
    }
    Explained {
        objectName: "speedNumbers"
        Accessible.name: card.title
        quantities: [Explanations.FollowingError, Explanations.Torque]
    }
}
