// SPDX-License-Identifier: Apache-2.0
// The table of light tower and horn: a row for each condition of the machine, a list of modes for each cell.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property TowerFields tower: Maintenance.tower
    readonly property var colors: [Theme.color.fault, Theme.color.warning, Theme.color.good, Theme.color.ink]
    readonly property var modes: tower.modes
    readonly property int columns: section.tower.lights.length
    readonly property real nameWidth: Math.round(table.width * 0.2)
    readonly property real cellWidth: (table.width - nameWidth - columns * Theme.size.spacing) / columns

    title: qsTr("Light tower and horn")

    onVisibleChanged: {
        if (section.visible)
            section.tower.readIfUncertain()
    }
    Component.onCompleted: section.tower.readIfUncertain()
    Connections {
        target: Controller
        function onConnectionChanged(): void { section.tower.readIfUncertain() }
    }

    Label {
        objectName: "towerEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: section.tower.emptyText.length > 0
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: section.tower.emptyText
        color: Theme.color.secondaryInk
    }
    Item {
        id: table
        anchors { fill: parent; topMargin: section.bodyTop }
        visible: section.tower.emptyText.length === 0

        Row {
            id: head
            x: section.nameWidth + Theme.size.spacing
            spacing: Theme.size.spacing
            Repeater {
                model: section.tower.lights
                Item {
                    id: light
                    required property int index
                    required property string modelData
                    width: section.cellWidth
                    height: caption.height + sign.height + Theme.size.accent
                    Rectangle {
                        id: sign
                        anchors.horizontalCenter: parent.horizontalCenter
                        width: Theme.size.icon
                        height: Theme.size.icon
                        radius: light.index < 3 ? width / 2 : Theme.size.accent
                        color: section.colors[light.index]
                    }
                    Label {
                        id: caption
                        anchors { top: sign.bottom; topMargin: Theme.size.accent; left: parent.left; right: parent.right }
                        horizontalAlignment: Text.AlignHCenter
                        wrapMode: Text.WordWrap
                        text: light.modelData
                        font.pixelSize: Theme.size.caption
                        color: Theme.color.secondaryInk
                    }
                }
            }
        }
        Flickable {
            id: list
            anchors { left: parent.left; right: parent.right; top: head.bottom; topMargin: Theme.size.spacing; bottom: foot.top; bottomMargin: Theme.size.spacing }
            contentHeight: cells.height
            clip: true
            boundsBehavior: Flickable.StopAtBounds
            Column {
                spacing: Theme.size.spacing
                Repeater {
                    model: section.tower.conditions
                    Label {
                        required property string modelData
                        width: section.nameWidth
                        height: Theme.size.touch
                        verticalAlignment: Text.AlignVCenter
                        wrapMode: Text.WordWrap
                        fontSizeMode: Text.Fit
                        text: modelData
                        font.bold: true
                    }
                }
            }
            Grid {
                id: cells
                x: section.nameWidth + Theme.size.spacing
                columns: section.columns
                spacing: Theme.size.spacing
                Repeater {
                    model: section.tower
                    Button {
                        id: cell
                        required property int index
                        required property string name
                        required property string value
                        required property int choice
                        required property bool known
                        objectName: "tower" + index
                        width: section.cellWidth
                        height: Theme.size.touch
                        enabled: cell.known
                        // "Blinks, then on" in two lines.
                        readonly property var parts: cell.value.split(", ")
                        text: cell.parts[0]
                        note: cell.parts[1] ?? ""
                        kind: cell.choice > 0 ? Button.Normal : Button.Quiet
                        Accessible.name: Theme.fill(qsTr("%1: %2"), [cell.name, cell.value])
                        onClicked: Frame.open("Controls/ListPicker", {
                            title: cell.name,
                            choices: section.modes.map((text, key) => ({ key: key, text: text })),
                            current: cell.choice,
                            level: Access.Technician,
                            onChosen: key => section.tower.setChoice(cell.index, key)
                        })
                    }
                }
            }
        }
        ScrollMark { view: list }
        ParameterFoot {
            id: foot
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            fields: section.tower
            name: "tower"
        }
    }
}
