// SPDX-License-Identifier: Apache-2.0
// The regime map: the fastest rate over the bag length and the limit that sets it. A finger drags the recipe's dot; the
// length and the rate follow at once, and one undo takes the whole drag back. Where an encoder leads, the rate is shown as
// the speed of the line.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Plot

Sheet {
    id: sheet

    property int revision                  // of the mapping, which the dot follows
    readonly property bool good: Editor.severity !== Editor.Severity.Bad

    title: Editor.cutter.map.title.length > 0 ? Editor.cutter.map.title : qsTr("Regime map")
    note: Editor.cutter.map.text

    Component.onCompleted: Editor.cutter.map.watched = true
    Component.onDestruction: Editor.cutter.map.watched = false

    // `at` is the revision of the mapping that a binding depends on.
    function dotX(lengthMm: real, at: int): real { return plot.xOfLength(lengthMm) }
    function dotY(rate: real, at: int): real { return plot.yOfRate(rate) }

    RegimePlot {
        id: plot
        objectName: "regimePlot"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: tools.top; bottomMargin: Theme.size.spacing }
        map: Editor.cutter.map.map
        limitNames: Editor.cutter.map.limitNames
        marks: Editor.cutter.map.paperLengths
        shownRate: finger.pressed ? finger.shownRate : Editor.cutter.map.onAxis || 0
        rateUnit: Editor.cutter.map.axisUnit
        lengthUnit: Theme.shownUnit("mm")
        lengthFactor: Theme.unitFactor("mm")
        refusedName: qsTr("not possible")
        marksName: qsTr("reference lengths")
        limitColors: [Theme.color.acceleration, Theme.color.touch, Theme.color.frequency, Theme.color.position, Theme.color.jerk, Theme.color.secondaryInk]
        gridColor: Theme.color.line
        surfaceColor: Theme.color.surface
        insetColor: Theme.color.inset
        inkColor: Theme.color.ink
        secondaryInkColor: Theme.color.secondaryInk
        lineWidth: Theme.size.curve
        axisFont: Theme.captionFont
        onLayoutChanged: ++sheet.revision
    }
    Binding {
        target: plot
        property: "locale"
        value: Theme.locale
    }
    Rectangle {
        id: dot
        objectName: "regimeDot"
        visible: Editor.cutter.map.title.length > 0
        width: Theme.size.handle
        height: width
        radius: width / 2
        x: plot.x + sheet.dotX(Editor.cutter.map.lengthMm, sheet.revision) - width / 2
        y: plot.y + sheet.dotY(Editor.cutter.map.onAxis, sheet.revision) - height / 2
        color: finger.holds ? Theme.color.touch : Theme.color.surface
        border { width: 2 * Theme.size.curve; color: sheet.good ? Theme.color.touch : Theme.color.fault }
    }
    MouseArea {
        id: finger
        objectName: "regimeFinger"
        Accessible.role: Accessible.Graphic
        Accessible.name: qsTr("Regime map")
        anchors.fill: plot
        preventStealing: true
        property bool holds
        property real shownRate            // the scale stands still during a drag
        property point grab                // px from the finger to the dot

        onPressed: mouse => {
            grab = Qt.point(plot.xOfLength(Editor.cutter.map.lengthMm) - mouse.x, plot.yOfRate(Editor.cutter.map.onAxis) - mouse.y)
            shownRate = Editor.cutter.map.onAxis || 0
            holds = dot.visible && Math.hypot(grab.x, grab.y) <= Theme.size.touch * 0.75
        }
        onPositionChanged: mouse => {
            if (holds)
                Editor.cutter.map.drag(plot.lengthOfX(mouse.x + grab.x), plot.rateOfY(mouse.y + grab.y))
        }
        onReleased: finish()
        onCanceled: finish()

        function finish() {
            if (holds)
                Editor.cutter.map.endDrag()
            holds = false
        }
    }
    Label {
        objectName: "regimeVerdict"
        anchors { left: parent.left; right: tools.left; rightMargin: Theme.size.padding; top: tools.top; bottom: parent.bottom }
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Theme.unbroken(sheet.good ? qsTr("Drag the dot to another length and rate.") + "\n" + Editor.cutter.map.linesText : Editor.verdict)
        color: sheet.good ? Theme.color.secondaryInk : Theme.color.fault
    }
    Row {
        id: tools
        anchors { right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        Button {
            objectName: "regimeSuggestion"
            level: Editor.suggestionLevel
            visible: text.length > 0
            kind: Button.Primary
            text: Editor.suggestionText
            onClicked: Editor.applySuggestion()
        }
        Button {
            objectName: "regimeUndo"
            Accessible.name: qsTr("Undo")
            width: Theme.size.touch
            kind: Button.Quiet
            glyph: Theme.icon.undo
            enabled: Editor.undoLevel >= 0
            level: Editor.undoLevel
            onClicked: Editor.undo()
        }
    }
}
