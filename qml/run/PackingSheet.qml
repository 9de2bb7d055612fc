// SPDX-License-Identifier: Apache-2.0
// The numbers of a packing machine behind its picture: mark tracking, skipped cuts and their causes.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property PackingLine line: Controller.packing
    readonly property real half: Math.floor((width - 2 * Theme.size.gap - 4 * Theme.size.padding) / 2)

    title: qsTr("Marks, cuts and film")

    component Heading: Label {
        width: sheet.half
        color: Theme.color.secondaryInk
        font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
    }
    component Figure: ValueTile {
        width: sheet.half
        height: Math.round(Theme.size.body * 2.1)
    }

    Column {
        Heading { text: Controller.run.marks }
        Figure { objectName: "sheetMarkError"; label: qsTr("Mark error of the last cut"); value: "packer.mark_error" }
        Figure { label: qsTr("Mark distance"); value: "packer.mark_pitch" }
        Figure { label: qsTr("Shift of the next cut"); value: "packer.phase_correction" }
        Figure { label: qsTr("Length correction"); value: "packer.length_correction" }
        Figure { label: qsTr("Corrections at limit"); value: "packer.corrections_limited" }
        Figure { label: qsTr("Tracked marks"); value: "packer.marks" }
        Figure { label: qsTr("Missing marks"); value: "packer.marks_missing" }
        Figure { label: qsTr("Unexpected marks"); value: "packer.marks_false" }
    }
    Column {
        anchors.right: parent.right
        Heading { text: qsTr("Cuts and film") }
        Figure { label: qsTr("Products"); value: "packer.products" }
        Figure { label: qsTr("Skipped cuts, product in the way"); value: "packer.cuts_skipped" }
        Figure { label: qsTr("Bags without product"); value: "packer.empty_bags" }
        Figure { label: qsTr("Film saved"); value: "packer.film_saved" }
        Figure { label: qsTr("Following error of the knife"); text: Theme.signedMeasure(Controller.live.followingErrorMm, 2, "mm") }
        Figure { label: qsTr("Following error of the film"); value: "packer.film_following_error" }
        Item { width: 1; height: Theme.size.spacing }
        FilmLegend { width: sheet.half }
    }
}
