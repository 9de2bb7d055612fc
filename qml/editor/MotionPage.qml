// SPDX-License-Identifier: Apache-2.0
// Motion: the recipe as numbers on the left, as curves on the right, and the verdict with the next step below.
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

    function openMore(): void {
        Frame.open("Editor/MoreSheet", {
            page: page, onKindRequested: () => Frame.open("Editor/KindSheet", { onChosen: kind => Editor.newProgram(kind) })
        })
    }

    bannerLeft: side.width + Theme.size.gap
    bannerBottom: verdict.height + Theme.size.gap

    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { left: parent.left; top: parent.top; bottom: verdict.top; bottomMargin: Theme.size.gap }

        CutterInputs {
            visible: page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            onMoreRequested: page.openMore()
        }
        KindInputs {
            visible: !page.isCutter
            anchors { fill: parent; margins: Theme.size.spacing }
            onMoreRequested: page.openMore()
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
        pageWidth: page.width
        anchors { left: parent.left; leftMargin: page.editorBeside ? page.leftInset + Theme.size.gap : 0; right: parent.right; bottom: parent.bottom }
    }
}
