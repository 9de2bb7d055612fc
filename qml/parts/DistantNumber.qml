// SPDX-License-Identifier: Apache-2.0
// A number that is read from some metres: its whole part in digits of 14 mm, what is behind the point in small ones; gray while
// its data is old. Its height is that of the digits, which stand on its lower edge.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: number
    Accessible.role: Accessible.StaticText
    Accessible.name: (number.text + " " + number.unit).trim()
    Accessible.description: number.title

    required property string text          // in the panel's language
    property string title                  // of the card; for a reader
    property string unit
    property color ink: Theme.color.ink
    property bool stale
    property int pixelSize: Theme.size.distant   // at most; less when there is no room

    readonly property int point: text.lastIndexOf(Theme.locale.decimalPoint)
    readonly property string decimals: point < 0 ? "" : text.slice(point)
    readonly property real decimalShare: 0.45
    readonly property real naturalWidth: Math.ceil(whole.advanceWidth + decimalShare * rest.advanceWidth)
    readonly property int fitted: Math.floor(Math.min(pixelSize, height / Theme.size.digitShare, pixelSize * width / Math.max(1, naturalWidth)))
    readonly property color color: stale ? Theme.color.disabledInk : ink

    implicitWidth: naturalWidth
    implicitHeight: Math.round(pixelSize * Theme.size.digitShare)

    TextMetrics {
        id: whole
        font { pixelSize: number.pixelSize; bold: true }
        text: number.text.slice(0, number.text.length - number.decimals.length)
    }
    TextMetrics {
        id: rest
        font: whole.font
        text: number.decimals
    }
    Label {
        id: digits
        anchors.baseline: parent.bottom
        text: whole.text
        color: number.color
        font { pixelSize: Math.max(1, number.fitted); bold: true }
    }
    Label {
        anchors { left: digits.right; baseline: parent.bottom }
        text: number.decimals
        color: number.stale ? Theme.color.disabledInk : Theme.color.secondaryInk
        font { pixelSize: Math.max(1, Math.round(number.decimalShare * number.fitted)); bold: true }
    }
}
