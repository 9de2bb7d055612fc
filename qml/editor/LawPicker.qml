// SPDX-License-Identifier: Apache-2.0
// The speed laws with their effects on this recipe.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    title: Editor.lawTitle
    note: sheet.isByHand ? qsTr("The figures are those of the ratios set by hand; the law that is gentlest with its own ramps is first")
        : sheet.isCutter ? qsTr("The gentlest law is first, each with the ramps that suit it; hold a law to compare its curves")
        : qsTr("Peak values of each law for this recipe; hold a law to compare its curves")
    readonly property bool isByHand: isCutter && Editor.cutter.ramps.mode === RampControl.ByHand
    readonly property bool isCutter: Editor.kind === Editor.Kind.RotaryCutter
    readonly property bool compares: Editor.overlayName.length > 0

    Component.onCompleted: Editor.watchLaws(true)
    Component.onDestruction: Editor.watchLaws(false)

    LawRow {
        id: head
        anchors { left: parent.left; right: parent.right; rightMargin: 2 * Theme.size.accent; top: parent.top }
        height: Math.max(Theme.size.caption * 3, wordsHeight)
        header: true
        cells: [...Editor.lawColumns]
    }
    ListView {
        id: list
        objectName: "lawList"
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: comparison.visible ? comparison.top : parameters.visible ? parameters.top : parent.bottom; bottomMargin: comparison.visible || parameters.visible ? Theme.size.spacing : 0 }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Editor.laws
        delegate: LawRow {
            required property string lawId
            required property string name
            required shape
            required property string strength
            required property string weakness
            required property string peakRpmText
            required property string peakAccelerationText
            required property string rmsText
            required property string peakFrequencyText
            required property string peakJerkText
            required property string vibrationText
            required property bool current
            required property bool compared
            required usable
            objectName: "law_" + lawId
            level: usable ? Access.Technician : Access.Viewer
            text: name
            notes: [strength, weakness]
            holds: current
            cells: [peakRpmText, peakAccelerationText, ...(rmsText.length > 0 ? [rmsText] : []), peakJerkText, peakFrequencyText,
                    ...(vibrationText.length > 0 ? [vibrationText] : [])]
            marked: compared
            onClicked: {
                if (usable)
                    Editor.setLaw(lawId)
            }
            onPressAndHold: Editor.compareLaw(compared ? "" : lawId)
        }
    }
    ScrollMark { view: list }
    Item {
        id: comparison
        visible: sheet.compares
        anchors { left: parent.left; right: parent.right; bottom: parameters.visible ? parameters.top : parent.bottom }
        height: 3 * Theme.size.touch
        StyledCurves {
            objectName: "lawCurves"
            visible: sheet.compares
            anchors { left: parent.left; right: legend.left; rightMargin: Theme.size.spacing; top: parent.top; bottom: parent.bottom }
            curves: Editor.plot.curves
            overlayCurves: Editor.overlayCurves
            quantities: ["velocity", "acceleration"]
        }
        Column {
            id: legend
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            width: Math.round(parent.width * 0.3)
            spacing: Theme.size.spacing
            Label {
                width: parent.width
                wrapMode: Text.WordWrap
                text: Theme.fill(qsTr("Color: %1, grey: %2"), [Editor.lawName, Editor.overlayName])
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Button {
                objectName: "endComparison"
                width: parent.width
                text: qsTr("End comparison")
                onClicked: Editor.compareLaw("")
            }
        }
    }
    Row {
        id: parameters
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        spacing: Theme.size.spacing
        visible: Editor.lawParameter1.visible || Editor.lawParameter2.visible
        Repeater {
            model: [Editor.lawParameter1, Editor.lawParameter2]
            FieldTile {
                required property var modelData
                item: modelData as EditorField
                compact: false
                width: (parameters.width - parameters.spacing) / 2
                height: parameters.height
            }
        }
    }
}
