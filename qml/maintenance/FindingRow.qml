// SPDX-License-Identifier: Apache-2.0
// One finding of the link doctor: place, problem, action.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

ListRow {
    required property string title
    required note
    required detail
    required property bool usable

    tappable: false
    frame: Theme.size.hairline
    frameColor: usable ? Theme.color.good : Theme.color.line
    text: title
    glyph: usable ? Theme.icon.check : Theme.icon.alert
    sign.color: usable ? Theme.color.good : Theme.color.warning
    titleLabel { wrapMode: Text.WordWrap; fontSizeMode: Text.FixedSize }
    noteLabel { text: note + "\n" + detail; wrapMode: Text.WordWrap; fontSizeMode: Text.FixedSize }
}
