// SPDX-License-Identifier: Apache-2.0
// A large number with its unit on the same line; gray while its data is old.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: readout
    Accessible.role: Accessible.StaticText
    Accessible.name: readout.known && readout.unit.length > 0 ? readout.text + " " + readout.unit : readout.text

    required property string text
    property string unit
    property bool stale
    readonly property bool known: text !== Theme.unknownText
    property int pixelSize: Theme.size.hero
    property color ink: Theme.color.ink

    implicitWidth: number.implicitWidth + (unit.length > 0 ? suffix.implicitWidth + Theme.size.spacing : 0)
    implicitHeight: number.implicitHeight

    Label {
        id: number
        text: readout.text
        width: Math.min(implicitWidth, readout.width - (readout.unit.length > 0 ? suffix.width + Theme.size.spacing : 0))
        height: parent.height
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.body
        font { pixelSize: readout.pixelSize; bold: true }
        color: readout.stale ? Theme.color.disabledInk : readout.ink
    }
    Label {
        id: suffix
        visible: readout.known             // an unknown value has no unit
        anchors { left: number.right; leftMargin: Theme.size.spacing; baseline: number.baseline }
        text: readout.unit
        color: Theme.color.secondaryInk
        font { pixelSize: Math.max(Theme.size.caption, Math.round(readout.pixelSize * 0.42)); weight: Font.DemiBold }
    }
}
