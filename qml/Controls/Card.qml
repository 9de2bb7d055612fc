// SPDX-License-Identifier: Apache-2.0
// A surface for related content.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    color: Theme.color.surface
    radius: Theme.size.radius
}
