// SPDX-License-Identifier: Apache-2.0
// One entry of a list of choices, with a tick when it is selected.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

ListRow {
    mark: Theme.icon.check
    arrow.opacity: holds ? 1 : 0
    titleLabel.wrapMode: Text.Wrap              // below the smallest size; a word only where it is wider than the row
    noteLabel.fontSizeMode: Text.FixedSize
    noteLabel.wrapMode: Text.WordWrap
}
