// SPDX-License-Identifier: Apache-2.0
// Run: what the program of the controller moves and makes. Each kind has its own view; only the one in use is loaded.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Machine

Page {
    id: page

    // By Machine.active.kind: no program, cutter (of a controller that tells nothing of film and marks), position move, speed move, point cam, press.
    readonly property list<string> views: ["RunEmpty.qml", "RunCutter.qml", "RunAxis.qml", "RunAxis.qml", "RunAxis.qml", "RunPress.qml"]
    readonly property string view: Machine.active.kind === 1 && Machine.packing.present ? "RunPacking.qml" : page.views[Machine.active.kind]

    Loader {
        id: loader
        anchors.fill: parent
        source: page.view
    }
    Connections {
        target: loader.item
        ignoreUnknownSignals: true
        function onExplainRequested(quantities: var) { page.numbersExplainRequested(quantities) }
        function onSheetRequested(sheet: Component) { page.sheetRequested(sheet) }
    }
    Binding {
        target: loader.item
        property: "bottomInset"
        value: page.bottomInset
    }
}
