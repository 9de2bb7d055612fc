// SPDX-License-Identifier: Apache-2.0
// The top bar: the program that the machine runs and the open recipe when that is another, state of the controller as text, icon and color, the most urgent alarm, link, clock. For display
// only.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Rectangle {
    id: bar

    property date now: new Date()
    property bool clockRuns: true

    // One entry per Machine.State.
    readonly property list<string> stateIcons: [Theme.icon.unknown, Theme.icon.stop, Theme.icon.good, Theme.icon.run, Theme.icon.stop,
        Theme.icon.moving, Theme.icon.referenceRun, Theme.icon.fault]
    readonly property list<color> stateColors: [Theme.color.secondaryInk, Theme.color.secondaryInk, Theme.color.touch, Theme.color.good,
        Theme.color.touch, Theme.color.touch, Theme.color.touch, Theme.color.fault]
    readonly property color stateColor: Controller.fresh ? stateColors[Controller.state] : Theme.color.disabledInk

    implicitHeight: Theme.size.topBar
    color: Theme.color.surface

    Rectangle {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.size.hairline
        color: Theme.color.line
    }
    Column {
        id: recipe
        anchors { left: parent.left; leftMargin: Theme.size.gap + Theme.size.accent; verticalCenter: parent.verticalCenter }
        readonly property real room: Math.min(bar.width * 0.36, state.x - recipe.x - Theme.size.padding)
        Label {
            objectName: "recipeTitle"
            Accessible.role: Accessible.StaticText
            Accessible.name: text
            width: Math.min(implicitWidth, recipe.room)
            fontSizeMode: Text.HorizontalFit
            text: Controller.active.isPresent ? ProgramNames.active
                : Controller.fresh && Controller.state === Controller.State.Idle ? qsTr("No program") : qsTr("Program unknown")
            color: Controller.fresh ? Theme.color.ink : Theme.color.disabledInk
            font { pixelSize: open.visible ? Theme.size.body : Theme.size.title; bold: true }
        }
        Label {
            id: open
            objectName: "openTitle"
            visible: ProgramNames.isOtherMotion || ProgramNames.isOtherVersion || !Controller.active.isPresent || Editor.edited
            width: Math.min(implicitWidth, recipe.room)
            fontSizeMode: Text.HorizontalFit
            text: Theme.fill(qsTr("open: %1"), [ProgramNames.open])
            color: Theme.color.secondaryInk
            font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
        }
    }
    Row {
        id: state
        anchors { horizontalCenter: parent.horizontalCenter; verticalCenter: parent.verticalCenter }
        spacing: Theme.size.spacing
        IconLabel {
            anchors.verticalCenter: parent.verticalCenter
            code: bar.stateIcons[Controller.state]
            color: bar.stateColor
        }
        Label {
            objectName: "stateText"
            Accessible.role: Accessible.StaticText
            Accessible.name: text
            anchors.verticalCenter: parent.verticalCenter
            width: Math.min(implicitWidth, 0.2 * bar.width)
            fontSizeMode: Text.HorizontalFit
            text: Controller.stateText
            color: bar.stateColor
            font { pixelSize: Theme.size.title; bold: true }
        }
        Label {
            objectName: "ageText"
            anchors.verticalCenter: parent.verticalCenter
            visible: !Controller.fresh && !isNaN(Controller.ageMs)
            text: qsTr("%1 s ago").arg(Theme.number(Controller.ageMs / 1000, 0))
            color: Theme.color.disabledInk
            font.pixelSize: Theme.size.caption
        }
    }
    UrgentAlarm {
        anchors { left: state.right; leftMargin: Theme.size.padding; right: line.left; rightMargin: Theme.size.padding; top: parent.top; bottom: parent.bottom }
    }
    Row {
        id: line
        anchors { right: parent.right; rightMargin: Theme.size.gap + Theme.size.accent; verticalCenter: parent.verticalCenter }
        spacing: Theme.size.padding
        Row {
            anchors.verticalCenter: parent.verticalCenter
            visible: Access.protectedByPins
            spacing: Theme.size.accent
            IconLabel {
                anchors.verticalCenter: parent.verticalCenter
                code: Theme.icon.user
                color: Access.loggedIn ? Theme.color.touch : Theme.color.secondaryInk
            }
            Column {
                anchors.verticalCenter: parent.verticalCenter
                Label {
                    objectName: "userName"
                    visible: Access.loggedIn
                    width: Math.min(implicitWidth, bar.width * 0.13)
                    text: Access.userName
                    font { pixelSize: Theme.size.caption; weight: Font.DemiBold }
                }
                Label {
                    objectName: "userLevel"
                    text: Access.levelText
                    color: Theme.color.secondaryInk
                    font.pixelSize: Theme.size.caption - 1
                }
            }
        }
        Label {
            anchors.verticalCenter: parent.verticalCenter
            visible: Controller.simulated
            text: qsTr("Simulated")
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        LinkBars {
            anchors.verticalCenter: parent.verticalCenter
            quality: Controller.linkQuality
        }
        Label {
            anchors.verticalCenter: parent.verticalCenter
            text: qsTr("%1/s").arg(Theme.number(Controller.statusPerSecond, 0))
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            anchors.verticalCenter: parent.verticalCenter
            text: Qt.formatTime(bar.now, "hh:mm")
            font { pixelSize: Theme.size.title; weight: Font.DemiBold }
        }
    }
    Timer {
        interval: Theme.clockTime
        running: bar.clockRuns
        repeat: true
        onTriggered: bar.now = new Date()
    }
}
