// SPDX-License-Identifier: Apache-2.0
// The controller's inputs and outputs, and its fault and warning bits, live; or the parameters of its cam switches.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property IoList io: Maintenance.io
    readonly property CamSwitches switches: Maintenance.switches
    property bool isSetting

    function nameOf(number: int) : string {
        return number < section.switches.drives ? qsTr("Cam switch %1").arg(number) : qsTr("Drive")
    }

    onShownChanged: shown => {
        section.io.watched = shown
        section.isSetting = section.isSetting && shown
    }

    Flickable {
        id: list
        objectName: "ioList"
        visible: !section.isSetting
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top; bottomMargin: Theme.size.spacing }
        contentHeight: Math.max(pins.height, bits.height)
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: pins
            width: Math.round((list.width - 3 * Theme.size.padding) * 0.54)
            spacing: Theme.size.spacing
            IoColumn {
                objectName: "ioInputs"
                width: parent.width
                title: qsTr("Inputs")
                io: section.io
                side: Io.Input
            }
            IoColumn {
                objectName: "ioOutputs"
                width: parent.width
                title: qsTr("Outputs")
                io: section.io
                side: Io.Output
            }
        }
        Column {
            id: bits
            anchors { left: pins.right; leftMargin: 2 * Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding }
            spacing: Theme.size.spacing
            IoColumn {
                objectName: "ioFaults"
                width: parent.width
                title: qsTr("Fault bits")
                io: section.io
                side: Io.Fault
                withValues: false
            }
            IoColumn {
                objectName: "ioWarnings"
                width: parent.width
                title: qsTr("Warning bits")
                io: section.io
                side: Io.Warning
                withValues: false
            }
        }
    }
    ScrollMark {
        view: list
        visible: list.visible && list.visibleArea.heightRatio < 1
    }
    Item {
        id: foot
        visible: !section.isSetting
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Math.max(text.implicitHeight, change.visible ? change.height : 0)
        Label {
            id: text
            objectName: "ioText"
            anchors { left: parent.left; right: change.visible ? change.left : parent.right; rightMargin: change.visible ? Theme.size.padding : 0; verticalCenter: parent.verticalCenter }
            wrapMode: Text.WordWrap
            text: section.io.stale ? qsTr("No data from the controller: grey values were received last.")
                : section.io.hasPins ? qsTr("A filled lamp means on. Limit switches are only displayed. The emergency stop ends the motion, but no safety depends on it.")
                : qsTr("This controller reports the counts of its inputs, not the levels of its pins. A filled lamp means on.")
            color: section.io.stale ? Theme.color.warning : Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Button {
            id: change
            objectName: "ioSwitches"
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            visible: section.io.hasPins
            text: qsTr("Cam switches")
            onClicked: {
                section.switches.choose(section.switches.current)
                section.isSetting = true
            }
        }
    }
    Item {
        anchors.fill: parent
        visible: section.isSetting
        Button {
            id: back
            objectName: "ioBack"
            anchors { left: parent.left; top: parent.top }
            text: qsTr("Back")
            onClicked: section.isSetting = false
        }
        SettingRow {
            id: chosen
            objectName: "ioSwitch"
            anchors { left: back.right; leftMargin: Theme.size.spacing; right: parent.right; top: parent.top }
            label: qsTr("Output")
            value: section.nameOf(section.switches.current)
            onClicked: Frame.open("Controls/ListPicker", {
                title: qsTr("Output"), current: section.switches.current, onChosen: key => section.switches.choose(key),
                choices: Array.from({ length: section.switches.drives }, (none, i) => i > 0 ? i : section.switches.drives)
                    .map(key => ({ key: key, text: section.nameOf(key) }))
            })
        }
        ParameterList {
            anchors { left: parent.left; right: parent.right; top: chosen.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom }
            fields: section.switches
            name: "camSwitch"
        }
    }
}
