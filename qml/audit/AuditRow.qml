// SPDX-License-Identifier: Apache-2.0
// One row of the audit trail: object, old and new value, user and time.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    required property string time
    required property string clockNote
    required property string who
    required property string what
    required property string object
    required property string change
    required property string problem

    Accessible.name: what
    text: object.length > 0 ? Theme.fill(qsTr("%1 · %2"), [what, object]) : what
    note: problem.length > 0 ? problem : change
    noteLabel.color: problem.length > 0 ? Theme.color.warning : Theme.color.secondaryInk
    rightText: who
    rightNote: clockNote.length > 0 ? Theme.fill(qsTr("%1 · %2"), [time, clockNote]) : time
}
