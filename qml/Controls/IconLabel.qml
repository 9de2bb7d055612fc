// SPDX-License-Identifier: Apache-2.0
// One icon of the icon font; its code comes from Theme.icon.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Text {
    required property string code

    text: code
    color: Theme.color.ink
    font.family: Theme.iconFamily
    font.pixelSize: Theme.size.icon
    textFormat: Text.PlainText
    horizontalAlignment: Text.AlignHCenter
    verticalAlignment: Text.AlignVCenter
}
