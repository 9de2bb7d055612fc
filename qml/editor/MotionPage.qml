// SPDX-License-Identifier: Apache-2.0
// Motion: the recipe as numbers on the left, as curves on the right, and the verdict with the next step below.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Download
import CamPanel.Panel

Page {
    id: page

    property bool showPosition
    property bool showJerk
    property bool showTorque
    property bool compare: true
    readonly property bool editorBeside: leftInset > 0   // over the numbers and the texts of the verdict
    readonly property bool isCutter: Editor.kind === Editor.Kind.RotaryCutter

    bannerLeft: side.width + Theme.size.gap
    bannerBottom: verdict.height + Theme.size.gap

    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { left: parent.left; top: parent.top; bottom: verdict.top; bottomMargin: Theme.size.gap }

        CutterInputs {
            visible: page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onExplainRequested: field => page.explainRequested(field)
            onLawRequested: page.sheetRequested(page.lawSheet)
            onRatiosRequested: page.sheetRequested(page.ratioSheet)
            onMoreRequested: page.sheetRequested(page.moreSheet)
        }
        KindInputs {
            visible: !page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onExplainRequested: field => page.explainRequested(field)
            onLawRequested: page.sheetRequested(page.lawSheet)
            onKnotsRequested: page.sheetRequested(page.knotSheet)
            onSegmentsRequested: page.sheetRequested(page.segmentSheet)
            onChoiceRequested: (row, name, options, option) => {
                page.chosen = { row: row, title: name, options: options, current: option }
                page.sheetRequested(page.choiceSheet)
            }
            onMoreRequested: page.sheetRequested(page.moreSheet)
        }
    }
    CurveEditor {
        anchors {
            left: parent.left; leftMargin: Math.max(side.width, page.leftInset) + Theme.size.gap; right: parent.right
            top: side.top; bottom: side.bottom; bottomMargin: page.bottomInset
        }
        verdictVisible: page.editorBeside
        showPosition: page.showPosition
        showJerk: page.showJerk
        showTorque: page.showTorque
        compare: page.compare && (Editor.programDownload.differenceCount > 0 || Editor.overlayName.length > 0)
    }
    VerdictBar {
        id: verdict
        textsVisible: !page.editorBeside
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        onDownloadRequested: page.sheetRequested(page.downloadSheet)
        onExplainRequested: quantities => page.numbersExplainRequested(quantities)
    }

    readonly property Component lawSheet: Component {
        LawPicker { onEditRequested: (fields, index, source) => page.editRequested(fields, index, source) }
    }
    readonly property Component ratioSheet: Component {
        RatioSheet {
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onExplainRequested: quantities => page.numbersExplainRequested(quantities)
        }
    }
    property var chosen: ({ row: 0, title: "", options: [], current: 0 })
    readonly property Component choiceSheet: Component {
        ChoiceSheet {
            title: page.chosen.title
            row: page.chosen.row
            options: page.chosen.options
            current: page.chosen.current
        }
    }
    readonly property Component knotSheet: Component {
        KnotSheet {
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onFilesRequested: page.sheetRequested(page.camFilesSheet)
        }
    }
    readonly property Component camFilesSheet: Component {
        CamFilesSheet { onTaken: page.sheetRequested(Editor.kind === Editor.Kind.SegmentCam ? page.segmentSheet : page.knotSheet) }
    }
    readonly property Component segmentSheet: Component {
        SegmentSheet {
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onMotionRequested: page.sheetRequested(page.segmentMotionSheet)
            onFilesRequested: page.sheetRequested(page.camFilesSheet)
        }
    }
    readonly property Component segmentMotionSheet: Component {
        SegmentMotionSheet { onPicked: page.sheetRequested(page.segmentSheet) }
    }
    readonly property Component kindSheet: Component {
        KindSheet {
            onChosen: key => {
                Editor.newProgram(key)
                closed()
            }
        }
    }
    firstSheet: downloadSheet
    readonly property Component downloadSheet: Component {
        DownloadSheet { onProofRequested: page.sheetRequested(page.proofSheet) }
    }
    readonly property Component proofSheet: Component {
        ProofSheet {}
    }
    readonly property Component tableSheet: Component {
        TableSheet {}
    }
    readonly property Component regimeSheet: Component {
        RegimeSheet {}
    }
    readonly property Component moreSheet: Component {
        MoreSheet {
            showPosition: page.showPosition
            showJerk: page.showJerk
            showTorque: page.showTorque
            compare: page.compare
            onPositionToggled: on => page.showPosition = on
            onJerkToggled: on => page.showJerk = on
            onTorqueToggled: on => page.showTorque = on
            onCompareToggled: on => page.compare = on
            onTableRequested: page.sheetRequested(page.tableSheet)
            onProofRequested: page.sheetRequested(page.proofSheet)
            onMapRequested: page.sheetRequested(page.regimeSheet)
            onKindRequested: page.sheetRequested(page.kindSheet)
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
            onExplainRequested: field => page.explainRequested(field)
        }
    }
}
