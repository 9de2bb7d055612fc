// SPDX-License-Identifier: Apache-2.0
// A button that steps a value, and goes on to do so while it is held.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Button {
    autoRepeat: !locked
    autoRepeatDelay: Theme.holdTime
    autoRepeatInterval: Theme.repeatTime
}
