// SPDX-License-Identifier: Apache-2.0
// A sheet in the place of another one, which stays below it with what it holds, until the upper one is closed. A file: an inline
// component cannot be loaded there.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls

Loader {
    id: place

    required property Sheet below

    parent: place.below
    anchors.fill: parent
    active: false

    Connections {
        target: place.item
        function onClosed() { place.active = false }
    }
    // The lower sheet does not close over a text that is typed here.
    Binding {
        target: place.below
        property: "pending"
        value: (place.item as Overlay)?.pending ?? false
        when: place.active
    }
    Binding {
        target: place.item
        property: "warned"
        value: place.below.warned
        when: place.item !== null
    }
}
