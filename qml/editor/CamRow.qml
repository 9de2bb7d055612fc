// SPDX-License-Identifier: Apache-2.0
// A knot or segment in the list of its sheet: number and place, below what it does.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    required property int number
    required property string place
    required property bool selected
    property bool warns

    mark: ""
    holds: selected
    titleLabel.text: number
    rightText: place
    noteLabel { wrapMode: Text.WordWrap; maximumLineCount: 2; color: warns ? Theme.color.warning : Theme.color.secondaryInk }
}
