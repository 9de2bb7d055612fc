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

    readonly property var brightnesses: Display.brightnessChoices
    readonly property var waits: Display.darkChoices
    readonly property var rotations: ScreenRotation.choices
    property int field                     // of the network that is entered

    title: qsTr("Screen and system")

    component Caption: Label {
        width: parent.width
        fontSizeMode: Text.HorizontalFit
        minimumPixelSize: Theme.size.caption - 2
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
            width: scroll.width - 2 * Theme.size.accent
            spacing: Theme.size.spacing
            Caption {
                visible: Display.adjustable
                text: qsTr("Brightness")
            }
            Segmented {
                visible: Display.adjustable
                objectName: "brightnessChoice"
                width: parent.width
                choices: section.brightnesses.map(percent => ({ key: percent, text: qsTr("%1 %").arg(percent), name: "brightness" + percent }))
                current: Display.brightness
                onChosen: key => Display.brightness = key
            }
            Caption {
                wrapMode: Text.Wrap
                fontSizeMode: Text.FixedSize
                text: qsTr("Screen off after minutes without touch, at standstill")
            }
            Row {
                id: darkRow
                width: parent.width
                spacing: Theme.size.gap
                Segmented {
                    objectName: "darkChoice"
                    width: darkRow.width - wipeKey.width - darkRow.spacing
                    choices: section.waits.map(minutes => ({ key: minutes, text: minutes === 0 ? qsTr("Never") : String(minutes), name: "dark" + minutes }))
                    current: Display.darkAfterMinutes
                    onChosen: key => Display.darkAfterMinutes = key
                }
                Button {
                    id: wipeKey
                    objectName: "wipeScreen"
                    text: qsTr("Clean")
                    onClicked: Display.wipe()
                }
            }
            SettingRow {
                objectName: "setClock"
                width: parent.width
                label: qsTr("Clock")
                value: Theme.fill(qsTr("%1, %2"), [facts.clockText, facts.zoneText])
                onClicked: {
                    if (Access.ask(Access.Service))
                        section.page.sheetRequested(clockSheet)
                }
            }
            SettingRow {
                objectName: "setNetwork"
                width: parent.width
                label: qsTr("Network")
                value: facts.lines.length > 0 ? facts.lines.join(" · ") : qsTr("not connected")
                onClicked: {
                    if (Access.ask(Access.Service)) {
                        SystemNetwork.discard()
                        section.page.sheetRequested(networkSheet)
                    }
                }
            }
            Row {
                id: screenRow
                width: parent.width
                spacing: Theme.size.gap
                SettingRow {
                    objectName: "setRotation"
                    width: (screenRow.width - screenRow.spacing) / 2
                    enabled: ScreenRotation.blockedReason.length === 0
                    label: qsTr("Screen rotation")
                    value: qsTr("%1°").arg(ScreenRotation.degrees)
                    onClicked: {
                        if (Access.ask(Access.Service))
                            section.page.sheetRequested(rotationPicker)
                    }
                }
                SettingRow {
                    objectName: "setTouch"
                    width: (screenRow.width - screenRow.spacing) / 2
                    enabled: TouchCalibration.blockedReason.length === 0
                    label: qsTr("Touchscreen")
                    value: !TouchCalibration.available ? "--" : TouchCalibration.calibrated ? qsTr("calibrated") : qsTr("not calibrated")
                    Component.onCompleted: TouchCalibration.watched = true
                    Component.onDestruction: TouchCalibration.watched = false
                    onClicked: {
                        if (Access.ask(Access.Service))
                            section.page.sheetRequested(touchPicker)
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
    ScrollMark { view: scroll }

    Component {
        id: clockSheet
        ClockSheet { onZoneRequested: section.page.sheetRequested(zonePicker) }
    }
    Component {
        id: zonePicker
        ZonePicker { onClosed: section.page.sheetRequested(clockSheet) }
    }
    Component {
        id: networkSheet
        NetworkSheet {
            onPortRequested: section.page.sheetRequested(portPicker)
            onFieldRequested: field => {
                section.field = field
                section.page.sheetRequested(addressPad)
            }
        }
    }
    Component {
        id: portPicker
        ListPicker {
            title: qsTr("Network port")
            choices: SystemNetwork.ports
            current: SystemNetwork.port
            onChosen: key => {
                SystemNetwork.port = key
                closed()
            }
            onClosed: section.page.sheetRequested(networkSheet)
        }
    }
    Component {
        id: rotationPicker
        ListPicker {
            title: qsTr("Screen rotation")
            choices: section.rotations.map(degrees => ({ key: degrees, text: qsTr("%1°").arg(degrees) }))
            current: ScreenRotation.degrees
            onChosen: key => {
                closed()
                ScreenRotation.tryOut(key)
            }
        }
    }
    Component {
        id: touchPicker
        ListPicker {
            readonly property var calibrate: ({ key: "calibrate", text: qsTr("Calibrate"), note: qsTr("touch four crosses; the panel restarts") })
            readonly property var remove: ({ key: "remove", text: qsTr("Remove calibration"), note: qsTr("as before the first one; the panel restarts") })
            title: qsTr("Touchscreen")
            choices: TouchCalibration.calibrated ? [calibrate, remove] : [calibrate]
            current: null
            onChosen: key => {
                closed()
                if (key === "remove")
                    TouchCalibration.remove()
                else
                    TouchCalibration.begin()
            }
        }
    }
    Component {
        id: addressPad
        AddressPad {
            field: section.field
            onClosed: section.page.sheetRequested(networkSheet)
        }
    }
}
