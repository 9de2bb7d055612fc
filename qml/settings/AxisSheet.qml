// SPDX-License-Identifier: Apache-2.0
// The measurement of one value of an axis: what will move, the key that moves it, what came of it, and whether to take it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property AxisMeasurement measurement: Maintenance.measurement
    readonly property int step: measurement.step
    readonly property bool film: measurement.subject === AxisMeasurement.Subject.Film
    readonly property bool ended: step === AxisMeasurement.Step.Done || step === AxisMeasurement.Step.Failed
    readonly property bool asks: step === AxisMeasurement.Step.Question

    title: measurement.title
    panelWidth: width * 0.9
    pending: step === AxisMeasurement.Step.Moving || step === AxisMeasurement.Step.Writing

    Component.onCompleted: sheet.measurement.setWatchedBy(sheet, true)
    Component.onDestruction: sheet.measurement.setWatchedBy(sheet, false)

    component MotionKey: CommandKey {
        level: Access.Technician
        width: Math.round(1.6 * Theme.size.commandKey)
        small: true
    }

    Label {
        id: words
        objectName: "axisText"
        anchors { left: parent.left; right: parent.right; top: parent.top }
        wrapMode: Text.WordWrap
        text: sheet.measurement.text
        color: sheet.step === AxisMeasurement.Step.Failed ? Theme.color.fault
            : sheet.step === AxisMeasurement.Step.Done ? Theme.color.good : Theme.color.ink
        font { pixelSize: sheet.asks ? Theme.size.title : Theme.size.body; weight: sheet.asks || sheet.ended ? Font.DemiBold : Font.Normal }
    }
    Label {
        id: reason
        objectName: "axisReason"
        anchors { left: parent.left; right: parent.right; top: words.bottom; topMargin: Theme.size.spacing }
        visible: text.length > 0 && !sheet.ended
        wrapMode: Text.WordWrap
        text: sheet.measurement.blockedReason || (sheet.film ? HandBags.bagReason : "")
        color: Theme.color.warning
        font.weight: Font.DemiBold
    }
    ProgressBar {
        anchors { left: parent.left; right: parent.right; top: words.bottom; topMargin: Theme.size.padding }
        visible: sheet.step === AxisMeasurement.Step.Moving && sheet.measurement.subject === AxisMeasurement.Subject.Turns
        progress: sheet.measurement.progress
    }
    Row {
        anchors { left: parent.left; bottom: parent.bottom; bottomMargin: Theme.size.padding }
        spacing: Theme.size.padding * 2
        visible: !sheet.asks
        Readout {
            objectName: "axisPresent"
            title: qsTr("Present setting")
            text: sheet.measurement.presentText
            pixelSize: Theme.size.title
        }
        Readout {
            objectName: "axisMeasured"
            visible: sheet.step === AxisMeasurement.Step.Result
            title: qsTr("Measured")
            text: sheet.measurement.measuredText
            pixelSize: Theme.size.title
            ink: sheet.measurement.canTake ? Theme.color.touch : Theme.color.warning
        }
    }
    Row {
        anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: Theme.size.padding }
        spacing: Theme.size.padding * 2
        visible: sheet.asks
        MotionKey {
            objectName: "axisRight"
            width: 2 * Theme.size.commandKey
            holdMs: 0
            glyph: Theme.icon.jogForward
            text: qsTr("As it should")
            onCommanded: sheet.measurement.keepDirection()
        }
        MotionKey {
            objectName: "axisWrong"
            width: 2 * Theme.size.commandKey
            holdMs: 0
            glyph: Theme.icon.jogReverse
            text: qsTr("The other way")
            note: qsTr("Reverses the motor")
            onCommanded: sheet.measurement.turnAround()
        }
    }
    footer: [
        Button {
            objectName: "axisLeave"
            text: sheet.step === AxisMeasurement.Step.Result ? qsTr("Leave") : sheet.ended ? qsTr("Close") : qsTr("Cancel")
            onClicked: sheet.closed()
        },
        Button {
            objectName: "axisRuler"
            visible: sheet.film && sheet.step === AxisMeasurement.Step.Ready && Controller.simulated
            enabled: sheet.measurement.hasBag
            text: qsTr("Read ruler")
            onClicked: sheet.measurement.measureSimulatedBag()
        },
        Button {
            objectName: "axisEnter"
            level: Access.Technician
            visible: sheet.film && !sheet.ended && !sheet.pending
            enabled: sheet.measurement.hasBag
            glyph: Theme.icon.edit
            text: qsTr("Enter …")
            onClicked: Frame.edit([sheet.measurement.ruler], 0, null, "")
        },
        Button {
            objectName: "axisTake"
            level: Access.Technician
            visible: sheet.step === AxisMeasurement.Step.Result
            enabled: sheet.measurement.canTake
            kind: Button.Primary
            text: qsTr("Take")
            onClicked: sheet.measurement.take()
        },
        MotionKey {
            objectName: "axisBag"
            visible: sheet.film && sheet.step === AxisMeasurement.Step.Ready
            level: Access.Operator
            glyph: Theme.icon.start
            text: qsTr("One bag")
            ready: HandBags.bagReason.length === 0
            onCommanded: HandBags.makeBag()
        },
        MotionKey {
            objectName: "axisStart"
            visible: !sheet.film && !sheet.asks && !sheet.pending && sheet.step !== AxisMeasurement.Step.Result
            glyph: Theme.icon.jogForward
            text: sheet.ended ? qsTr("Measure again") : qsTr("Measure")
            ready: sheet.measurement.blockedReason.length === 0
            onCommanded: sheet.measurement.start()
        }
    ]
}
