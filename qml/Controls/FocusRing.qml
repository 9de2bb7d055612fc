// SPDX-License-Identifier: Apache-2.0
// The ring around what the keyboard presses, above everything. It comes with the first Tab. A touch ends it and gives the
// keys back to what had them before. While `region` is set, the focus stays within it.
pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import CamPanel.Theme

Item {
    id: ring

    property Item region
    readonly property Item focused: Window.activeFocusItem
    readonly property T.Control control: focused as T.Control
    readonly property bool shown: control !== null && control.visualFocus
    property Item before                   // had the keys before the first Tab
    property rect place

    function isInside(item: Item, ancestor: Item): bool {
        for (; item && item !== ancestor; item = item.parent) {}
        return item !== null
    }
    // Scrolls the lists around the control until it is in sight.
    function reveal(): void {
        for (let each = ring.control.parent; each; each = each.parent) {
            const view = each as Flickable
            if (!view)
                continue
            const top = ring.control.mapToItem(view.contentItem, 0, 0).y
            view.contentY = Math.max(top + ring.control.height - view.height, Math.min(top, view.contentY))
        }
    }
    // Moves the focus on until it is within the region.
    function confine(): void {
        if (!ring.control?.visualFocus)
            return
        let next = ring.control
        for (let i = 0; i < 500 && ring.region && !ring.isInside(next, ring.region); ++i)
            next = next.nextItemInFocusChain()
        if (next !== ring.control)
            next.forceActiveFocus(Qt.TabFocusReason)
        else
            ring.reveal()
    }
    function follow(): void {
        ring.place = ring.control.mapToItem(ring, 0, 0, ring.control.width, ring.control.height)
    }

    objectName: "focusRing"
    visible: shown
    onFocusedChanged: {
        if (!(ring.focused as T.Control))
            ring.before = ring.focused
    }
    onControlChanged: nextTurn.restart()
    onShownChanged: nextTurn.restart()

    // Another focus within the change would be a loop.
    Timer {
        id: nextTurn
        interval: 0
        onTriggered: ring.confine()
    }
    Connections {
        target: ring.shown ? ring.Window.window : null
        function onAfterAnimating() { ring.follow() }
    }
    PointHandler {
        onActiveChanged: {
            if (!active || !ring.control)
                return
            const had = ring.before
            ring.control.focus = false
            if (had?.parent)               // not the window itself
                had.forceActiveFocus(Qt.MouseFocusReason)
        }
    }
    Rectangle {
        x: ring.place.x - Theme.size.accent
        y: ring.place.y - Theme.size.accent
        width: ring.place.width + 2 * Theme.size.accent
        height: ring.place.height + 2 * Theme.size.accent
        radius: Theme.size.radius + Theme.size.accent
        color: "transparent"
        border { width: Theme.size.accent; color: Theme.color.ink }
    }
}
