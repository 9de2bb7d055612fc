// SPDX-License-Identifier: Apache-2.0
// A part of a machine as a box: motor, gear, carriage.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    property bool marked

    radius: Theme.size.radius
    color: marked ? Theme.color.touchTint : Theme.color.inset
    border { width: Theme.size.outline; color: marked ? Theme.color.touch : Theme.color.target }
}
