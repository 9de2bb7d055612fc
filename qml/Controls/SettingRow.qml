// SPDX-License-Identifier: Apache-2.0
// A setting as a field: its name in small letters above its value. A tap opens its choices.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

ListRow {
    id: row

    required property string label
    required property string value
    readonly property bool tooLong: smallest.advanceWidth > noteLabel.width

    text: row.label
    note: row.value
    detail: row.value
    titleLabel { minimumPixelSize: Theme.size.smallestText; wrapMode: Text.NoWrap; color: Theme.color.secondaryInk; font { pixelSize: Theme.size.caption; weight: Font.Normal } }
    noteLabel {
        wrapMode: row.tooLong ? Text.WordWrap : Text.NoWrap
        maximumLineCount: 2
        color: row.locked ? Theme.color.secondaryInk : Theme.color.ink
        lineHeight: noteLabel.lineCount > 1 ? 0.85 : 1
        font { pixelSize: row.tooLong ? Theme.size.caption : Theme.size.title; weight: Font.DemiBold }
    }
    TextMetrics {
        id: smallest
        font { pixelSize: Theme.size.smallestText; weight: Font.DemiBold }
        text: row.value
    }
}
