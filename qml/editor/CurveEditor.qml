// SPDX-License-Identifier: Apache-2.0
// The motion as curves with handles to drag: the four ends of segments of a cutter, the knots or segments of a cam. The
// cursor's values are above the curves, not under the finger.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: editor

    required property bool showPosition
    required property bool showJerk
    required property bool showTorque
    required property bool compare
    required property bool verdictVisible  // a verdict other than good takes the place of the peaks
    readonly property bool warns: verdictVisible && Editor.solvable && isNaN(cursor) && Editor.severity !== Editor.Severity.Good
    readonly property CamHandles handles: Editor.handles
    readonly property bool hasHandles: handles !== null
    readonly property bool isPress: Editor.kind === Editor.Kind.Press
    readonly property list<real> handleTimes: handles !== null ? handles.times : Editor.plot.ratioTimes
    readonly property int handlePanel: quantities.indexOf(hasHandles ? "position" : "velocity")
    readonly property var quantities: [...(showPosition || hasHandles || isPress ? ["position"] : []), "velocity", "acceleration",
        ...(showJerk ? ["jerk"] : []), ...(showTorque && Editor.plot.hasTorque ? ["torque"] : []), "frequency"]
    property int dragged: -1
    property real cursor: NaN
    property int revision
    readonly property int kind: Editor.kind
    onKindChanged: editor.cursor = NaN     // it was a time of the other motion

    // Handles and readout follow the curves; `at` is the revision of the mapping that a binding depends on.
    function handleX(index: int, at: int): real { return plot.xOfTime(editor.handleTimes[index]) }
    function selectionX(index: int, at: int): real { return plot.xOfTime(editor.handles?.selection[index] ?? 0) }
    function handleY(index: int, at: int): real {
        return plot.yOfValue(editor.handlePanel, plot.valuesAt(editor.handleTimes[index])[editor.handlePanel])
    }
    // Returns the end of a stage of a press; -1 is the start of the stroke.
    function stageX(index: int, at: int): real {
        return plot.xOfTime(index < 0 ? 0 : Editor.plot.markTimes[index] ?? Editor.plot.cycleSeconds)
    }
    function handleAt(x: real, y: real): int {
        const reach = Theme.size.touch / 2
        const near = editor.handleTimes.map((time, i) => i).filter(i => Math.hypot(editor.handleX(i, 0) - x, (editor.handleY(i, 0) - y) / 2) <= reach)
        return near.reduce((best, i) => best < 0 || Math.abs(editor.handleX(i, 0) - x) < Math.abs(editor.handleX(best, 0) - x) ? i : best, -1)
    }
    function readout(time: real, at: int): string {
        const values = Array.from(plot.valuesAt(time)).map((value, i) => Theme.measure(value, 2, plot.metricUnits[editor.quantities[i]]))
        return [Theme.measure(time, 3, "s"), ...values].join("  ·  ")
    }

    Label {
        id: line
        objectName: "curveLine"
        anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.padding; topMargin: Theme.size.spacing }
        horizontalAlignment: Text.AlignRight
        wrapMode: Text.WordWrap
        text: editor.warns ? Theme.unbroken(Editor.verdict) : isNaN(editor.cursor) ? Theme.unbroken(Editor.plot.peakText) : editor.readout(editor.cursor, editor.revision)
        color: isNaN(editor.cursor) && !editor.warns ? Theme.color.secondaryInk : Theme.color.ink
        font { pixelSize: Theme.size.caption; weight: isNaN(editor.cursor) && !editor.warns ? Font.Normal : Font.DemiBold }
    }
    Item { // the stages of a stroke above its curve
        id: stages
        anchors { left: plot.left; right: plot.right; top: line.bottom }
        height: editor.isPress && plot.visible ? Math.round(1.4 * Theme.size.caption) : 0
        visible: height > 0
        Repeater {
            model: stages.visible ? Controller.stageNames : []
            Label {
                id: stage
                required property int index
                required property string modelData
                readonly property real from: editor.stageX(index - 1, editor.revision)
                x: from
                width: editor.stageX(index, editor.revision) - from
                height: stages.height
                horizontalAlignment: Text.AlignHCenter
                text: name.advanceWidth + Theme.size.outline < width ? modelData : index + 1
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
                TextMetrics {
                    id: name
                    font: stage.font
                    text: stage.modelData
                }
            }
        }
    }
    StyledCurves {
        id: plot
        objectName: "motionPlot"
        visible: Editor.solvable
        anchors { left: parent.left; right: parent.right; top: stages.bottom; bottom: parent.bottom; margins: Theme.size.spacing; topMargin: Theme.size.outline }
        curves: Editor.plot.curves
        overlayCurves: editor.compare ? Editor.overlayCurves : undefined
        quantities: editor.quantities
        style.labelGap: editor.hasHandles ? Theme.size.handle / 2 + Theme.size.outline : 2 * Theme.size.accent   // clear of the first handle
        titles: editor.quantities.map(quantity => editor.titleOf(quantity))
        markerTimes: editor.hasHandles ? [] : Editor.plot.markTimes
        cursorTime: editor.cursor
        cursorDotsVisible: editor.dragged < 0
        limitVelocity: Editor.plot.limitVelocity
        limitAcceleration: Editor.plot.limitAcceleration
        limitFrequency: Editor.plot.limitFrequency
        limitTorque: Editor.plot.limitTorque
        limitLabel: qsTr("limit")
        violations: Editor.plot.violations
        onLayoutChanged: ++editor.revision
        onCurvesChanged: ++editor.revision
    }
    Row { // what the dashed curve is
        id: legend
        visible: plot.visible && !!plot.overlayCurves   // none of a program of another kind
        anchors { right: plot.right; rightMargin: Theme.size.handle + Theme.size.padding; top: plot.top }   // beside a handle at the end
        spacing: Theme.size.accent
        Repeater { // dashes
            model: 3
            Rectangle {
                anchors.verticalCenter: parent.verticalCenter
                width: 2 * Theme.size.accent
                height: Theme.size.curve
                color: Theme.color.target
            }
        }
        Label {
            objectName: "overlayName"
            leftPadding: Theme.size.accent
            text: Editor.overlayName || (Controller.state === Controller.State.Running ? qsTr("running") : qsTr("in the controller"))
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    function titleOf(quantity: string): string {
        const unit = Theme.shownUnit(plot.metricUnits[quantity])
        return ({ position: qsTr("Position %1").arg(unit), velocity: qsTr("Velocity %1").arg(unit), acceleration: qsTr("Acceleration %1").arg(unit),
            jerk: qsTr("Jerk %1").arg(unit), frequency: qsTr("Pulse frequency kHz"), torque: qsTr("Motor torque Nm, RMS %1").arg(Theme.number(Editor.plot.rmsTorque, 3)) })[quantity]
    }
    // The selected knot as a line through all curves, the selected segment as a band.
    Repeater {
        model: editor.hasHandles && Editor.solvable ? editor.handles.selection.length / 2 : 0
        Rectangle {
            required property int index
            readonly property real from: editor.selectionX(2 * index, editor.revision)
            readonly property real to: editor.selectionX(2 * index + 1, editor.revision)
            objectName: "selection" + index
            x: plot.x + from
            width: Math.max(Theme.size.outline, to - from)
            y: plot.y
            height: plot.height
            color: Theme.color.touch
            opacity: to > from ? 0.12 : 0.6
        }
    }
    Repeater {
        model: Editor.solvable ? editor.handleTimes.length : 0
        Rectangle {
            required property int index
            readonly property bool holds: editor.handles !== null ? editor.handles.selected === index : editor.dragged === index
            objectName: "handle" + index
            width: editor.handleTimes.length > 12 ? Theme.size.handle / 2 : Theme.size.handle
            height: width
            radius: width / 2
            x: plot.x + editor.handleX(index, editor.revision) - width / 2
            y: plot.y + editor.handleY(index, editor.revision) - height / 2
            color: holds ? Theme.color.touch : Theme.color.surface
            border { width: Theme.size.curve; color: Permission.level < Access.Technician ? Theme.color.secondaryInk : Theme.color.touch }
        }
    }
    MouseArea {
        id: finger
        objectName: "curveFinger"
        Accessible.role: Accessible.Graphic
        Accessible.name: qsTr("Curve")
        anchors.fill: plot
        preventStealing: true
        enabled: Editor.solvable
        property real grab                 // px from the finger to the handle
        property point start               // start of the touch
        property real pixelSeconds         // scale at that moment: scales follow the curve
        property real pixelMm
        property bool hideCursor

        onPressed: mouse => {
            editor.dragged = editor.handleAt(mouse.x, mouse.y)
            grab = editor.dragged < 0 ? 0 : editor.handleX(editor.dragged, 0) - mouse.x
            hideCursor = editor.dragged < 0 && Math.abs(plot.xOfTime(editor.cursor) - mouse.x) < Theme.size.touch / 2
            start = Qt.point(mouse.x, mouse.y)
            pixelSeconds = plot.timeOfX(1) - plot.timeOfX(0)
            pixelMm = plot.valuePerPixel(editor.handlePanel)
            if (editor.hasHandles && editor.dragged >= 0)
                editor.handles.beginDrag(editor.dragged)
            plot.timeMaximum = Editor.plot.cycleSeconds
            follow(mouse.x, mouse.y)
        }
        onPositionChanged: mouse => {
            hideCursor = false
            follow(mouse.x, mouse.y)
        }
        onReleased: finish()
        onCanceled: finish()

        function follow(x: real, y: real) {
            if (editor.dragged >= 0 && editor.hasHandles)
                editor.handles.drag((x - start.x) * pixelSeconds, (start.y - y) * pixelMm)
            else if (editor.dragged >= 0)
                Editor.dragRatio(editor.dragged, plot.timeOfX(x + grab))
            editor.cursor = editor.dragged >= 0 ? editor.handleTimes[editor.dragged]
                : Math.max(0, Math.min(Editor.plot.cycleSeconds, plot.timeOfX(x)))
        }
        function finish() {
            if (editor.dragged >= 0 && editor.hasHandles)
                editor.handles.endDrag()
            else if (editor.dragged >= 0)
                Editor.commitDrag()
            if (editor.dragged >= 0 || hideCursor)
                editor.cursor = NaN
            editor.dragged = -1
            plot.timeMaximum = NaN
        }
    }
    Label {
        anchors.centerIn: plot
        visible: !Editor.solvable
        width: plot.width - 2 * Theme.size.padding
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: Theme.unbroken(Editor.verdict)
        color: Theme.color.secondaryInk
    }
}
