// SPDX-License-Identifier: Apache-2.0
// One stop: reason, who gave it, duration and begin.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    required property string time
    required property string clockNote     // empty: the clock was set
    required property string durationText
    required property string reasonText
    required property string stateText
    required property string by
    required property bool isOpen
    readonly property string given: by.length > 0 ? Theme.fill(qsTr("%1 · %2"), [stateText, by]) : stateText

    Accessible.name: time
    text: reasonText
    titleLabel.color: isOpen ? Theme.color.warning : Theme.color.ink
    note: clockNote.length > 0 ? Theme.fill(qsTr("%1 · %2"), [given, clockNote]) : given
    rightText: durationText
    rightLabel.color: Theme.color.ink
    rightNote: time
}
