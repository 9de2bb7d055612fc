// SPDX-License-Identifier: Apache-2.0
// The screen and the computer: brightness, automatic switch-off, cleaning; clock and network.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Parts

SettingsSection {
    id: section

    readonly property var rotations: ScreenRotation.choices

    function openNetwork(): void {
        Frame.open("Settings/NetworkSheet", {
            onPortRequested: () => section.choosePort(),
            onFieldRequested: field => Frame.open("Settings/AddressPad", { field: field, onClosed: () => section.openNetwork() })
        })
    }
    function choosePort(): void {
        Frame.open("Controls/ListPicker", {
            title: qsTr("Network port"), choices: SystemNetwork.ports, current: SystemNetwork.port,
            onChosen: key => SystemNetwork.port = key, onClosed: () => section.openNetwork()
        })
    }
    function openTouchscreen(): void {
        const calibrate = { key: "calibrate", text: qsTr("Calibrate"), note: qsTr("touch four crosses; the panel restarts") }
        const remove = { key: "remove", text: qsTr("Remove calibration"), note: qsTr("as before the first one; the panel restarts") }
        Frame.open("Controls/ListPicker", {
            title: qsTr("Touchscreen"), level: Access.Service, choices: TouchCalibration.calibrated ? [calibrate, remove] : [calibrate], current: null,
            onChosen: key => key === "remove" ? TouchCalibration.remove() : TouchCalibration.begin()
        })
    }

    title: qsTr("Screen and system")

    component Caption: Label {
        width: parent.width
        fontSizeMode: Text.HorizontalFit
        color: Theme.color.secondaryInk
    }
    NetworkInfo {
        id: facts
        readonly property var lines: networks
    }
    Flickable {
        id: scroll
        objectName: "systemScroll"
        anchors { fill: parent; topMargin: section.bodyTop }
        contentHeight: column.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Column {
            id: column
            width: scroll.width - scrollMark.room
            spacing: Theme.size.spacing
            Caption {
                visible: Display.adjustable
                text: brightness.field.label
            }
            SettingKeys {
                id: brightness
                visible: Display.adjustable
                objectName: "brightnessChoice"
                width: parent.width
                name: "display.brightness"
                keyName: "brightness"
            }
            Caption {
                wrapMode: Text.Wrap
                fontSizeMode: Text.FixedSize
                text: dark.field.label
            }
            Grid {
                id: darkRow
                readonly property real wipeWidth: Math.min(wipeKey.implicitWidth, Math.round(0.34 * width))
                readonly property real besideWidth: width - wipeWidth - spacing
                columns: besideWidth >= dark.choices.length * Theme.size.touch ? 2 : 1
                width: parent.width
                spacing: Theme.size.gap
                SettingKeys {
                    id: dark
                    objectName: "darkChoice"
                    width: darkRow.columns === 2 ? darkRow.besideWidth : darkRow.width
                    name: "display.dark_after_minutes"
                    keyName: "dark"
                }
                Button {
                    id: wipeKey
                    objectName: "wipeScreen"
                    width: darkRow.columns === 2 ? darkRow.wipeWidth : implicitWidth
                    text: qsTr("Clean the screen")
                    note: qsTr("30 s without touch")
                    onClicked: Display.wipe()
                }
            }
            SettingRow {
                objectName: "setClock"
                level: Access.Service
                width: parent.width
                label: qsTr("Clock")
                value: Theme.fill(qsTr("%1, %2"), [facts.clockText, facts.zoneText])
                onClicked: {
                    if (Access.ask(Access.Service))
                        Frame.open("Settings/ClockSheet", {})
                }
            }
            SettingRow {
                objectName: "setNetwork"
                level: Access.Service
                width: parent.width
                label: qsTr("Network")
                value: facts.lines.length > 0 ? facts.lines.join(" · ") : qsTr("not connected")
                onClicked: {
                    if (Access.ask(Access.Service))
                        section.openNetwork()
                }
            }
            Row {
                id: screenRow
                width: parent.width
                spacing: Theme.size.gap
                SettingRow {
                    objectName: "setRotation"
                    level: Access.Service
                    width: (screenRow.width - screenRow.spacing) / 2
                    enabled: ScreenRotation.blockedReason.length === 0
                    label: qsTr("Screen rotation")
                    value: qsTr("%1°").arg(ScreenRotation.degrees)
                    onClicked: {
                        if (!Access.ask(Access.Service))
                            return
                        Frame.open("Controls/ListPicker", {
                            title: qsTr("Screen rotation"), level: Access.Service, choices: section.rotations.map(degrees => ({ key: degrees, text: qsTr("%1°").arg(degrees) })),
                            current: ScreenRotation.degrees, onChosen: key => ScreenRotation.tryOut(key)
                        })
                    }
                }
                SettingRow {
                    objectName: "setTouch"
                    level: Access.Service
                    width: (screenRow.width - screenRow.spacing) / 2
                    enabled: TouchCalibration.blockedReason.length === 0
                    label: qsTr("Touchscreen")
                    value: !TouchCalibration.available ? "--" : TouchCalibration.calibrated ? qsTr("calibrated") : qsTr("not calibrated")
                    Component.onCompleted: TouchCalibration.watched = true
                    Component.onDestruction: TouchCalibration.watched = false
                    onClicked: {
                        if (Access.ask(Access.Service))
                            section.openTouchscreen()
                    }
                }
            }
            Caption {
                objectName: "screenBlocked"
                visible: text.length > 0
                wrapMode: Text.Wrap
                fontSizeMode: Text.FixedSize
                text: ScreenRotation.blockedReason.length > 0 ? ScreenRotation.blockedReason : TouchCalibration.blockedReason
            }
            Caption {
                visible: !Display.adjustable
                wrapMode: Text.Wrap
                fontSizeMode: Text.FixedSize
                text: qsTr("The brightness of this screen cannot be set here.")
            }
        }
    }
    ScrollMark { id: scrollMark; view: scroll }
}
