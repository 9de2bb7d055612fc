// SPDX-License-Identifier: Apache-2.0
// The master of the line: the encoder at its place as a drawing, with its angle live, and below it the machine data.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property MasterWatch master: Maintenance.master
    readonly property bool empty: section.master.emptyText.length > 0

    function watch(isShown: bool): void { section.master.setWatchedBy(section, isShown) }

    title: qsTr("Master")

    onVisibleChanged: section.watch(section.visible)
    Component.onCompleted: section.watch(section.visible)
    Component.onDestruction: section.watch(false)

    Label {
        objectName: "masterSetupEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: section.empty
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: section.master.emptyText
        color: Theme.color.secondaryInk
    }
    Column {
        id: heading
        y: -fields.headingHeight
        width: fields.width - 2 * Theme.size.accent
        spacing: Theme.size.spacing
        MasterDrawing {
            objectName: "masterSetupDrawing"
            width: parent.width
            height: Math.round(section.height * 0.28)
            master: section.master
        }
        Label {
            objectName: "masterSetupState"
            width: parent.width
            wrapMode: Text.WordWrap
            text: section.master.stateText
            color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
            font.weight: Font.DemiBold
        }
    }
    ParameterList {
        id: fields
        anchors { fill: parent; topMargin: section.bodyTop }
        visible: !section.empty
        fields: section.master.fields
        name: "master"
        heading: heading
    }
}
