// SPDX-License-Identifier: Apache-2.0
// One entry of a list of choices, with a tick when it is selected.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

ListRow {
    mark: Theme.icon.check
    arrow.opacity: holds ? 1 : 0
    noteLabel.fontSizeMode: Text.FixedSize
    noteLabel.wrapMode: Text.WordWrap
}
