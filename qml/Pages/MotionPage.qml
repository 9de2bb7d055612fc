// SPDX-License-Identifier: Apache-2.0
// Motion: the recipe as numbers at the left, as curves at the right, and the verdict with the next step below.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Widgets
import CamPanel.Machine

Page {
    id: page

    property bool showPosition
    property bool showJerk
    property bool compare: true
    readonly property var ratios: [Editor.k1, Editor.k2, Editor.k3, Editor.k4]
    readonly property int columns: Theme.size.fieldColumns
    readonly property int rows: 4 / columns + 2
    readonly property real rowHeight: (side.height - 2 * Theme.size.spacing - (rows - 1) * Theme.size.spacing) / rows

    Card {
        id: side
        width: Theme.size.sideColumn
        anchors { left: parent.left; top: parent.top; bottom: verdict.top; bottomMargin: Theme.size.gap }

        Grid {
            id: grid
            anchors { left: parent.left; right: parent.right; top: parent.top; margins: Theme.size.spacing }
            columns: page.columns
            spacing: Theme.size.spacing
            Repeater {
                model: [Editor.bagLength, Editor.rate, Editor.baseSpeed, Editor.filmSpeed]
                FieldTile {
                    required property var modelData
                    objectName: "field_" + field.fieldId
                    field: modelData as EditorField
                    compact: page.columns > 1
                    width: (grid.width - (page.columns - 1) * grid.spacing) / page.columns
                    height: page.rowHeight
                    onEditRequested: (field, source) => page.editRequested([field], 0, source)
                    onExplainRequested: field => page.explainRequested(field)
                }
            }
        }
        RatioGroup {
            id: ratioGroup
            objectName: "ratios"
            anchors { left: grid.left; right: grid.right; top: grid.bottom; topMargin: Theme.size.spacing }
            height: page.rowHeight
            fields: page.ratios
            onEditRequested: index => page.editRequested(page.ratios, index, ratioGroup)
        }
        SettingRow {
            id: lawButton
            objectName: "lawButton"
            anchors { left: grid.left; right: moreButton.left; rightMargin: Theme.size.spacing; top: ratioGroup.bottom; topMargin: Theme.size.spacing }
            height: page.rowHeight
            label: qsTr("Speed law")
            value: Editor.lawName
            onClicked: page.sheetRequested(page.lawSheet)
        }
        Button {
            id: moreButton
            objectName: "more"
            anchors { right: grid.right; top: lawButton.top }
            width: Theme.size.touch
            height: page.rowHeight
            glyph: Theme.icon.more
            onClicked: page.sheetRequested(page.moreSheet)
        }
    }
    CurveEditor {
        anchors { left: side.right; leftMargin: Theme.size.gap; right: parent.right; top: side.top; bottom: side.bottom }
        showPosition: page.showPosition
        showJerk: page.showJerk
        compare: page.compare && Editor.differenceCount > 0
    }
    VerdictBar {
        id: verdict
        visible: page.bottomInset === 0    // a banner takes its place
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        onDownloadRequested: page.sheetRequested(page.downloadSheet)
    }

    readonly property Component lawSheet: Component {
        LawPicker { onEditRequested: (fields, index, source) => page.editRequested(fields, index, source) }
    }
    readonly property Component downloadSheet: Component {
        DownloadSheet {}
    }
    readonly property Component tableSheet: Component {
        TableSheet {}
    }
    readonly property Component moreSheet: Component {
        MoreSheet {
            showPosition: page.showPosition
            showJerk: page.showJerk
            compare: page.compare
            onPositionToggled: on => page.showPosition = on
            onJerkToggled: on => page.showJerk = on
            onCompareToggled: on => page.compare = on
            onTableRequested: page.sheetRequested(page.tableSheet)
            onEditRequested: (fields, index, source) => page.editRequested(fields, index, source)
        }
    }
}
