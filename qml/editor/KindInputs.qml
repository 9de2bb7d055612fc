// SPDX-License-Identifier: Apache-2.0
// The inputs of every kind but the rotary cutter, from its tables: numbers, choices, law, knots, segments. What is longer
// than the screen is shown group by group.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: inputs

    signal moreRequested()

    readonly property int columns: Theme.size.fieldColumns
    readonly property real cell: (grid.width - (columns - 1) * grid.spacing) / columns
    readonly property var groupNames: ({
        move: qsTr("Move"), curve: qsTr("Curve"), master: qsTr("Master"), output: qsTr("Output"),
        approach: qsTr("Approach"), press: qsTr("Press"), limits: qsTr("Limits")
    })
    readonly property bool hasLaw: Editor.lawTitle.length > 0
    readonly property bool hasLists: Editor.kind === Editor.Kind.PointCam || Editor.kind === Editor.Kind.SegmentCam
    readonly property var shownFields: Array.from(Editor.fields).filter(field => field.visible)
    readonly property var groups: Object.keys(groupNames).filter(key => shownFields.some(field => field.group === key)
        || key === "curve" && (hasLaw || hasLists))
    // One of the choices of a cam, its master, is among the tools, and its list is here.
    readonly property int rows: (hasLaw ? 1 : 0) + Editor.choices.count + Math.ceil(shownFields.length / columns)
    readonly property bool grouped: rows * (Theme.size.touch + Theme.size.spacing) - Theme.size.spacing > list.height
    property int opened                    // as chosen by the finger; `shown` is among the groups
    readonly property int shown: Math.min(opened, groups.length - 1)
    readonly property int next: (shown + 1) % groups.length
    readonly property string group: grouped && shown >= 0 ? groups[shown] : ""    // none while the kind changes

    function has(group: string): bool {
        return !inputs.grouped || inputs.group === group
    }

    // The signal of the Editor comes with every solution.
    readonly property int kind: Editor.kind
    onKindChanged: inputs.opened = 0

    Flickable {
        id: list
        objectName: "inputList"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: moreButton.top; bottomMargin: Theme.size.spacing }
        contentHeight: body.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Column {
            id: body
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing

            SettingRow {
                objectName: "lawButton"
                visible: inputs.hasLaw && inputs.has("curve")
                width: body.width
                label: Editor.lawTitle
                value: Editor.lawName
                onClicked: Frame.open("Editor/LawPicker", {})
            }
            SettingRow {
                objectName: "knotsButton"
                visible: Editor.kind === Editor.Kind.PointCam && inputs.has("curve")
                width: body.width
                label: qsTr("Knots")
                value: Editor.cam.knots.count
                onClicked: Frame.open("Editor/KnotSheet", {})
            }
            SettingRow {
                objectName: "segmentsButton"
                visible: Editor.kind === Editor.Kind.SegmentCam && inputs.has("curve")
                width: body.width
                label: qsTr("Segments")
                value: Editor.cam.segments.count
                onClicked: Frame.open("Editor/SegmentSheet", {})
            }
            Repeater {
                model: inputs.visible ? Editor.choices : null
                SettingRow {
                    required property int index
                    required property string name
                    required property string valueText
                    required property list<string> options
                    required property int option
                    required property string group
                    objectName: "choice" + index
                    level: Access.Technician
                    visible: group !== "tools" && inputs.has(group)
                    width: body.width
                    label: name
                    value: valueText
                    onClicked: if (Access.ask(Access.Technician)) Frame.open("Editor/ChoiceSheet", { title: name, row: index, options: options, current: option })
                }
            }
            Grid {
                id: grid
                width: body.width
                columns: inputs.columns
                spacing: Theme.size.spacing

                Repeater {
                    model: inputs.visible ? Editor.fields : []
                    FieldTile {
                        required property var modelData
                        item: modelData as EditorField
                        visible: item.visible && inputs.has(item.group)
                        compact: inputs.columns > 1
                        width: inputs.cell
                        height: Theme.size.touch
                    }
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    Button {
        id: moreButton
        objectName: "more"
        Accessible.name: qsTr("View and tools")
        anchors { right: parent.right; bottom: parent.bottom }
        width: inputs.grouped ? Theme.size.touch : parent.width
        height: Theme.size.touch
        glyph: Theme.icon.more
        text: inputs.grouped ? "" : qsTr("View and tools")
        onClicked: inputs.moreRequested()
    }
    Button {
        objectName: "nextGroup"
        anchors { left: parent.left; right: moreButton.left; rightMargin: Theme.size.spacing; bottom: parent.bottom }
        visible: inputs.grouped
        height: Theme.size.touch
        text: qsTr("Next: %1").arg(inputs.groupNames[inputs.groups[inputs.next]] ?? "")
        note: Theme.fill(qsTr("%1, %2 of %3"), [inputs.groupNames[inputs.group] ?? "", inputs.shown + 1, inputs.groups.length])
        onClicked: inputs.opened = inputs.next
    }
}
