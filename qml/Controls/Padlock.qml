// SPDX-License-Identifier: Apache-2.0
// The mark of what asks for a login, in the upper right corner: nobody has to touch it to learn that.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

IconLabel {
    code: Theme.icon.lock
    color: Theme.color.secondaryInk
    font.pixelSize: Theme.size.caption
}
