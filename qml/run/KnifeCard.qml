// SPDX-License-Identifier: Apache-2.0
// How far the knife is from its limits: following error and torque as bars. A tap opens its speed over one cycle.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

RunTile {
    id: card

    // Twice a second: nobody reads more, and each other number is a picture to paint.
    readonly property int period: 500      // ms
    property real error: NaN
    property double seenAt: 0

    objectName: "knifeCard"
    title: qsTr("Knife")
    quantities: [Explanations.FollowingError, Explanations.Torque]
    onClicked: Frame.open("Run/KnifeSheet", {})

    Connections {
        target: Controller
        function onLiveChanged(): void {
            const now = Date.now()
            if (Theme.animated && now - card.seenAt < card.period)
                return
            card.seenAt = now
            card.error = Controller.live.followingErrorMm
        }
    }
    Component.onCompleted: card.error = Controller.live.followingErrorMm
    component Amount: Column {
        id: amount
        required property string label
        required property string text
        required property real value
        required property real limit       // NaN: unknown, and no bar
        width: parent.width
        Label {
            width: parent.width
            fontSizeMode: Text.HorizontalFit
            text: Theme.fill(qsTr("%1 %2"), [amount.label, amount.text])
            color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
            font.pixelSize: Theme.size.caption
        }
        LimitScale {
            width: parent.width
            visible: !isNaN(amount.limit)
            value: Math.abs(amount.value)
            limit: amount.limit
            end: 1.1 * amount.limit
            stale: !Controller.fresh
        }
    }

    Amount {
        id: following
        objectName: "followingAmount"
        label: qsTr("error")
        text: Theme.measure(card.error, 2, "mm")
        value: card.error
        limit: Controller.torque.followingLimitMm
    }
    Amount {
        objectName: "torqueAmount"
        label: qsTr("torque")
        text: Theme.joined(Theme.number(Controller.torque.measuredPercent, 0), "%")
        value: Controller.torque.measuredPercent
        limit: Controller.torque.limitPercent
        visible: !isNaN(value) && following.height + implicitHeight <= parent.height   // a tap shows it in any case
    }
}
