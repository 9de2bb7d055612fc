// SPDX-License-Identifier: Apache-2.0
// The entry of an address or a subnet mask.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

DigitPanel {
    id: entry

    required property int field            // a key of SystemNetwork.fields
    readonly property var fields: SystemNetwork.fields
    readonly property string refusal: SystemNetwork.refusalOf(field, pad.digits)

    title: SystemNetwork.label(field)
    sentence: SystemNetwork.hint(field)
    pending: pad.digits !== entry.fields[entry.field].text
    secret: false
    pad {
        secret: false
        pointed: true
        fewest: 0
        most: 15
        ready: entry.refusal.length === 0
        onAccepted: digits => {
            SystemNetwork.enter(entry.field, digits)
            entry.closed()
        }
    }
    Component.onCompleted: pad.digits = entry.fields[entry.field].text

    Label {
        objectName: "addressProblem"
        anchors.fill: parent
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: entry.refusal
        color: Theme.color.warning
    }
}
