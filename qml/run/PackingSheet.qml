// SPDX-License-Identifier: Apache-2.0
// The numbers of a packing machine behind its picture: mark tracking, skipped cuts and their causes.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property PackingLine line: Controller.packing
    readonly property color inkColor: Controller.fresh && line.fresh ? Theme.color.ink : Theme.color.disabledInk
    readonly property real half: Math.floor((width - 2 * Theme.size.gap - 4 * Theme.size.padding) / 2)

    title: qsTr("Marks, cuts and film")

    function millimeters(value: real): string {
        return isNaN(value) ? Theme.unknownText : qsTr("%1 mm").arg(Theme.signedNumber(value, 2))
    }

    component Heading: Label {
        width: sheet.half
        color: Theme.color.secondaryInk
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    component Figure: Item {
        id: figure
        required property string label
        required property string value
        width: sheet.half
        height: Math.round(Theme.size.body * 2.1)
        Label {
            anchors { left: parent.left; right: amount.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            text: figure.label
            fontSizeMode: Text.HorizontalFit
            minimumPixelSize: Theme.size.caption - 2
        }
        Label {
            id: amount
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            text: figure.value
            color: sheet.inkColor
            font.bold: true
        }
    }

    Column {
        Heading { text: sheet.line.markStateText }
        Figure { objectName: "sheetMarkError"; label: qsTr("Mark error of the last cut"); value: sheet.millimeters(sheet.line.markErrorMm) }
        Figure { label: qsTr("Mark distance"); value: isNaN(sheet.line.markPitchMm) ? Theme.unknownText : qsTr("%1 mm").arg(Theme.number(sheet.line.markPitchMm, 2)) }
        Figure { label: qsTr("Shift of the next cut"); value: sheet.millimeters(sheet.line.phaseCorrectionMm) }
        Figure { label: qsTr("Length correction"); value: sheet.millimeters(sheet.line.lengthCorrectionMm) }
        Figure { label: qsTr("Corrections at limit"); value: Theme.count(sheet.line.correctionsLimited, 0) }
        Figure { label: qsTr("Tracked marks"); value: Theme.count(sheet.line.marks, 0) }
        Figure { label: qsTr("Missing marks"); value: Theme.count(sheet.line.marksMissing, 0) }
        Figure { label: qsTr("Unexpected marks"); value: Theme.count(sheet.line.marksFalse, 0) }
    }
    Column {
        anchors.right: parent.right
        Heading { text: qsTr("Cuts and film") }
        Figure { label: qsTr("Products"); value: Theme.count(sheet.line.products, 0) }
        Figure { label: qsTr("Skipped cuts, product in the way"); value: Theme.count(sheet.line.cutsSkipped, 0) }
        Figure { label: qsTr("Bags without product"); value: Theme.count(sheet.line.emptyBags, 0) }
        Figure { label: qsTr("Film saved"); value: isNaN(sheet.line.filmSavedM) ? Theme.unknownText : qsTr("%1 m").arg(Theme.number(sheet.line.filmSavedM, 1)) }
        Figure { label: qsTr("Following error of the knife"); value: sheet.millimeters(Controller.live.followingErrorMm) }
        Figure { label: qsTr("Following error of the film"); value: sheet.millimeters(sheet.line.filmFollowingErrorMm) }
        Item { width: 1; height: Theme.size.spacing }
        FilmLegend { width: sheet.half }
    }
}
