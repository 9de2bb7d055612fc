// SPDX-License-Identifier: Apache-2.0
// Motion: the recipe as numbers on the left, and the verdict with the next step below. On the right the technician has the
// curves; the operator of a cutter has the rate that is possible, and what sets it. The page opens with the half of who is
// logged in.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Page {
    id: page

    property bool showPosition
    property bool showJerk
    property bool showTorque
    property bool compare: true
    readonly property bool editorBeside: leftInset > 0   // over the numbers and the texts of the verdict
    readonly property bool isCutter: Editor.kind === Editor.Kind.RotaryCutter
    property bool showsCurves: true
    readonly property bool technical: showsCurves || !isCutter   // an operator changes no number of the other kinds

    // Nothing changes its place because somebody logs in on the page.
    function begin(): void {
        page.showsCurves = Permission.level >= Access.Technician
    }
    Component.onCompleted: begin()

    function openMore(): void {
        Frame.open("Editor/MoreSheet", {
            page: page, onKindRequested: () => Frame.open("Editor/KindSheet", { onChosen: kind => Editor.newProgram(kind) })
        })
    }

    bannerLeft: side.width + Theme.size.gap
    bannerBottom: verdict.height + Theme.size.gap

    WindowLine {
        id: windowLine
        anchors { left: parent.left; leftMargin: page.editorBeside ? page.leftInset + Theme.size.gap : 0; right: parent.right; top: parent.top }
    }
    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { left: parent.left; top: windowLine.visible ? windowLine.bottom : parent.top; topMargin: windowLine.visible ? Theme.size.gap : 0; bottom: verdict.top; bottomMargin: Theme.size.gap }

        CutterInputs {
            visible: page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            technical: page.technical
            onMoreRequested: page.openMore()
            onCurvesRequested: page.showsCurves = true
        }
        KindInputs {
            visible: !page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            onMoreRequested: page.openMore()
        }
    }
    PossibleRate {
        visible: !page.technical
        anchors { left: side.right; leftMargin: Theme.size.gap; right: parent.right; top: side.top; bottom: side.bottom; bottomMargin: page.bottomInset }
    }
    CurveEditor {
        visible: page.technical
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
        technical: page.technical
        pageWidth: page.width
        anchors { left: parent.left; leftMargin: page.editorBeside ? page.leftInset + Theme.size.gap : 0; right: parent.right; bottom: parent.bottom }
    }
}
