// SPDX-License-Identifier: Apache-2.0
// The controller's inputs and outputs, and its fault and warning bits, live; or the parameters of its cam
// switches, drives and contacts. Removing the keys from the screen switches a tried output off.
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
    readonly property OutputTry trying: Maintenance.outputTry
    readonly property bool covered: Frame.covered
    readonly property bool inFront: Window.active
    property bool isSetting

    onShownChanged: shown => {
        section.io.watched = shown
        section.isSetting = section.isSetting && shown
        if (!shown)
            section.trying.letGo()
    }
    onCoveredChanged: {
        if (covered)
            section.trying.letGo()
    }
    onInFrontChanged: {
        if (!inFront)
            section.trying.letGo()
    }

    Flickable {
        id: list
        objectName: "ioList"
        visible: !section.isSetting
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top; bottomMargin: Theme.size.spacing }
        contentHeight: Math.max(first.height, second.height)
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: first
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
                objectName: "ioFaults"
                width: parent.width
                title: qsTr("Fault bits")
                io: section.io
                side: Io.Fault
                withValues: false
            }
        }
        Column {
            id: second
            anchors { left: first.right; leftMargin: 2 * Theme.size.padding; right: parent.right; rightMargin: Theme.size.padding }
            spacing: Theme.size.spacing
            IoColumn {
                objectName: "ioOutputs"
                width: parent.width
                title: qsTr("Outputs")
                io: section.io
                side: Io.Output
                trying: section.trying
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
                : section.io.hasPins ? section.trying.text
                : qsTr("This controller reports the counts of its inputs, not the levels of its pins. A filled lamp means on.")
            color: section.io.stale || section.trying.blocked ? Theme.color.warning : Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Button {
            id: change
            objectName: "ioSwitches"
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            visible: section.io.hasPins
            text: qsTr("Set up")
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
            label: qsTr("Input or output")
            value: section.switches.names[section.switches.current - 1]
            onClicked: Frame.open("Controls/ListPicker", {
                title: qsTr("Input or output"), current: section.switches.current, onChosen: key => section.switches.choose(key),
                choices: Array.from(section.switches.names, (name, i) => ({ key: i + 1, text: name }))
            })
        }
        ParameterList {
            anchors { left: parent.left; right: parent.right; top: chosen.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom }
            fields: section.switches
            name: "camSwitch"
        }
    }
}
