// SPDX-License-Identifier: Apache-2.0
// Text in the panel's font; plain, dark, body size unless said otherwise.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Text {
    color: Theme.color.ink
    font.pixelSize: Theme.size.body
    textFormat: Text.PlainText
    verticalAlignment: Text.AlignVCenter
}
