// SPDX-License-Identifier: Apache-2.0
// An encoder that leads the line: its drawing and state, the measured delay, its figures live.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property MasterWatch master: Maintenance.master
    readonly property bool empty: section.master.emptyText.length > 0
    readonly property int rowHeight: Math.round(Theme.size.caption * 1.7)

    onShownChanged: shown => section.master.setWatchedBy(section, shown)

    Label {
        objectName: "masterEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: section.empty
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: section.master.emptyText
        color: Theme.color.secondaryInk
    }
    Item {
        id: left
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        width: Math.round(parent.width * 0.42)
        visible: !section.empty
        MasterDrawing {
            objectName: "masterDrawing"
            anchors { left: parent.left; right: parent.right; top: parent.top; bottom: words.top; bottomMargin: Theme.size.spacing }
            master: section.master
        }
        Column {
            id: words
            anchors { left: parent.left; right: parent.right; bottom: key.top; bottomMargin: Theme.size.spacing }
            spacing: Theme.size.spacing
            Label {
                objectName: "masterState"
                width: parent.width
                wrapMode: Text.WordWrap
                text: section.master.stateText
                color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
                font.weight: Font.DemiBold
            }
            Label {
                objectName: "masterDelay"
                width: parent.width
                wrapMode: Text.WordWrap
                text: section.master.delayText
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Button {
            id: key
            objectName: "masterSetUp"
            anchors { left: parent.left; bottom: parent.bottom }
            text: qsTr("Set up")
            onClicked: Frame.openSection("settings", "MasterSetupSection.qml")
        }
    }
    Flickable {
        id: list
        objectName: "masterFigures"
        anchors { left: left.right; leftMargin: 2 * Theme.size.padding; right: parent.right; top: parent.top; bottom: parent.bottom }
        visible: !section.empty
        contentHeight: figures.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: figures
            width: list.width - Theme.size.padding
            Repeater {
                model: section.master.rows
                Item {
                    id: row
                    required property string name
                    required property string value
                    width: figures.width
                    height: Math.max(section.rowHeight, caption.implicitHeight)
                    Label {
                        id: caption
                        anchors { left: parent.left; right: amount.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
                        wrapMode: Text.WordWrap
                        text: row.name
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                    Label {
                        id: amount
                        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                        text: row.value
                        color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
                    }
                }
            }
        }
    }
    ScrollMark {
        view: list
        visible: list.visible && list.visibleArea.heightRatio < 1
    }
}
