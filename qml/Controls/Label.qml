// SPDX-License-Identifier: Apache-2.0
// Text in the panel's font; plain, dark, body size unless said otherwise. A text that fits its room (fontSizeMode) becomes no
// smaller than what can be read; what is longer then wraps or is elided.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Text {
    color: Theme.color.ink
    font.pixelSize: Theme.size.body
    minimumPixelSize: Theme.size.smallestText
    elide: Text.ElideRight
    textFormat: Text.PlainText
    verticalAlignment: Text.AlignVCenter
}
