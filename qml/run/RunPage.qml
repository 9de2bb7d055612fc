// SPDX-License-Identifier: Apache-2.0
// Run: the controller's program at work. Each kind has its own view; only the present one is loaded.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    // The views by Controller.active.kind: no program, cutter (of a controller without film and marks), position move, speed
    // move, point cam, press, segment cam.
    readonly property list<string> views: ["RunEmpty.qml", "RunCutter.qml", "RunAxis.qml", "RunAxis.qml", "RunAxis.qml", "RunPress.qml", "RunAxis.qml"]
    readonly property string view: Controller.active.kind === Editor.Kind.RotaryCutter && Controller.packing.present ? "RunPacking.qml" : page.views[Controller.active.kind]

    readonly property bool watchesOrder: page.visible && !Display.dark
    onWatchesOrderChanged: Orders.setWatchedBy(page, page.watchesOrder)

    showsFault: !Stops.asking && ((loader.item as RunPacking)?.showsFault ?? false)
    bannerRow: Stops.asking ? 0 : (loader.item as RunPacking)?.bannerRow ?? 0

    WindowLine {
        id: windowLine
        anchors { left: parent.left; right: parent.right; top: parent.top }
    }
    Loader {
        id: loader
        anchors { fill: parent; topMargin: windowLine.visible ? windowLine.height + Theme.size.gap : 0 }
        visible: !Stops.asking
        source: page.view
    }
    // In the place of the view, which shows nothing new while the machine stands.
    Loader {
        id: question
        anchors { fill: parent; bottomMargin: page.bottomInset }
        active: Stops.asking
        source: "StopQuestion.qml"
    }
    Binding {
        target: Controller.torque
        property: "watched"
        value: page.visible && !Display.dark && Controller.active.isPresent && Controller.active.kind !== Editor.Kind.Press
    }
    Binding {
        target: Controller.masterSetting
        property: "watched"
        value: page.visible && !Display.dark
    }
    Binding {
        target: loader.item
        property: "bottomInset"
        value: page.bottomInset
    }
}
