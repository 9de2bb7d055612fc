// SPDX-License-Identifier: Apache-2.0
// The controller's registers: filtered by group and name, read while they are visible; parameters can be written.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property RegisterInspector inspector: Maintenance.inspector
    readonly property int rowPitch: Theme.size.touch + Theme.size.outline

    function showRows(): void {
        section.inspector.setVisibleRows(Math.floor(list.contentY / section.rowPitch),
            Math.floor((list.contentY + list.height - 1) / section.rowPitch))
    }

    onShownChanged: shown => section.inspector.watched = shown

    Row {
        id: filters
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "registerGroup"
            width: (filters.width - 2 * filters.spacing - clearButton.width) / 2
            label: qsTr("Group")
            value: section.inspector.groupText
            onClicked: Frame.open("Controls/ListPicker", {
                title: qsTr("Group of registers"), choices: section.inspector.groups, current: section.inspector.group,
                onChosen: key => section.inspector.group = key
            })
        }
        SettingRow {
            objectName: "registerName"
            width: (filters.width - 2 * filters.spacing - clearButton.width) / 2
            label: qsTr("Name contains")
            value: section.inspector.nameFilter.length > 0 ? section.inspector.nameFilter : qsTr("any")
            onClicked: Frame.open("Controls/NameKeypad", {
                title: qsTr("Name contains"), note: Qt.binding(() => qsTr("%1 registers").arg(section.inspector.registers.count)),
                text: Qt.binding(() => section.inspector.nameFilter), onEdited: text => section.inspector.nameFilter = text
            })
        }
        Button {
            id: clearButton
            objectName: "registerClear"
            Accessible.name: qsTr("Clear the filter")
            glyph: Theme.icon.close
            enabled: section.inspector.group.length > 0 || section.inspector.nameFilter.length > 0
            onClicked: {
                section.inspector.group = ""
                section.inspector.nameFilter = ""
            }
        }
    }
    ListView {
        id: list
        objectName: "registerList"
        anchors { left: parent.left; right: parent.right; top: filters.bottom; bottom: foot.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: section.inspector.registers
        onContentYChanged: section.showRows()
        onHeightChanged: section.showRows()
        onCountChanged: section.showRows()
        delegate: RegisterRow {
            required property int index
            objectName: "register" + index
            holds: section.inspector.selected === index
            onClicked: section.inspector.select(index)
        }
    }
    ScrollMark { view: list }
    Label {
        anchors.fill: list
        visible: list.count === 0
        wrapMode: Text.WordWrap
        horizontalAlignment: Text.AlignHCenter
        text: qsTr("No register name contains this text.")
        color: Theme.color.secondaryInk
    }
    Item {
        id: foot
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.touch
        Label {
            objectName: "registerText"
            anchors { left: parent.left; right: writeButton.visible ? writeButton.left : parent.right; rightMargin: Theme.size.padding; top: parent.top; bottom: parent.bottom }
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: section.inspector.selectedText
            color: section.inspector.failed ? Theme.color.fault : section.inspector.selected < 0 ? Theme.color.secondaryInk : Theme.color.ink
        }
        Button {
            id: writeButton
            objectName: "registerWrite"
            level: Access.Service
            anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
            visible: section.inspector.writable
            enabled: section.inspector.canWrite
            kind: Button.Primary
            text: qsTr("Write …")
            onClicked: Frame.edit([section.inspector.value], 0, null, "")
        }
    }
}
