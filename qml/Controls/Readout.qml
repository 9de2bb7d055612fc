// SPDX-License-Identifier: Apache-2.0
// A number with its title above and its unit beside it, on one baseline; gray while its data is old. Every label, value and
// unit of a page is one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Item {
    id: readout
    Accessible.role: Accessible.StaticText
    Accessible.name: readout.known && readout.unit.length > 0 ? readout.text + " " + readout.unit : readout.text

    property string title                  // empty: none
    property color titleColor: Theme.color.secondaryInk
    property real titleInset               // px at its right that something else takes
    required property string text
    property string unit                   // as it is shown
    property bool stale
    property int pixelSize: Theme.size.hero
    property int smallest: Theme.size.body // px of the number when there is no room
    property bool atRight
    property color ink: Theme.color.ink
    readonly property bool known: text !== Theme.unknownText
    readonly property real gap: Math.round(pixelSize / 6)
    readonly property bool isSign: unit === "°"   // stands at the number itself
    readonly property bool hasSuffix: known && !isSign && unit.length > 0   // an unknown value has no unit
    readonly property real wholeSuffix: hasSuffix ? Math.ceil(whole.advanceWidth) + gap : 0
    readonly property bool tight: number.implicitWidth + wholeSuffix > width
    readonly property real suffixRoom: tight && hasSuffix ? suffix.implicitWidth + gap : wholeSuffix

    implicitWidth: Math.max(title.length > 0 ? Math.ceil(wholeTitle.advanceWidth) + titleInset : 0, number.implicitWidth + wholeSuffix)
    implicitHeight: (title.length > 0 ? caption.height : 0) + number.implicitHeight

    Label {
        id: caption
        width: readout.width - readout.titleInset
        visible: text.length > 0
        text: readout.title
        color: readout.titleColor
        font.pixelSize: Theme.size.caption
        // Two lines before the text becomes too small to read. The small letters are measured themselves, because whole
        // pixels make them wider than their share of the large ones.
        wrapMode: smallestTitle.advanceWidth > width ? Text.WordWrap : Text.NoWrap
        fontSizeMode: Text.HorizontalFit
        lineHeight: lineCount > 1 ? 0.85 : 1
        TextMetrics {
            id: wholeTitle
            font.pixelSize: Theme.size.caption
            text: readout.title
        }
        TextMetrics {
            id: smallestTitle
            font.pixelSize: Theme.size.smallestText
            text: readout.title
        }
    }
    Label {
        id: number
        x: readout.atRight ? readout.width - readout.suffixRoom - width : 0
        width: Math.min(implicitWidth, readout.width - readout.suffixRoom)
        anchors { top: readout.title.length > 0 ? caption.bottom : parent.top; bottom: parent.bottom }
        text: readout.isSign ? Theme.joined(readout.text, readout.unit) : readout.text
        horizontalAlignment: readout.atRight ? Text.AlignRight : Text.AlignLeft
        fontSizeMode: Text.Fit
        minimumPixelSize: readout.smallest
        font { pixelSize: readout.pixelSize; bold: true }
        color: readout.stale ? Theme.color.disabledInk : readout.ink
    }
    Label {
        id: suffix
        visible: readout.hasSuffix
        x: (readout.atRight ? number.x + number.width : number.x + number.contentWidth) + readout.gap
        anchors.baseline: number.baseline
        text: readout.unit
        color: Theme.color.secondaryInk
        font { pixelSize: readout.tight ? Theme.size.smallestText : whole.font.pixelSize; weight: whole.font.weight }
        TextMetrics {
            id: whole
            font { pixelSize: Math.max(Theme.size.caption, Math.round(readout.pixelSize * 0.42)); weight: readout.pixelSize > Theme.size.value ? Font.DemiBold : Font.Normal }
            text: readout.unit
        }
    }
}
