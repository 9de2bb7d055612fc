// SPDX-License-Identifier: Apache-2.0
// The code scanner: the keys around a code, and the last code that was read. While it is shown, a code opens nothing.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property real half: (width - Theme.size.spacing) / 2
    property bool shows

    onShownChanged: shown => {
        if (shown === section.shows)
            return
        section.shows = shown
        if (shown)
            Scan.beginEntry()
        else
            Scan.endEntry()
    }

    Grid {
        id: rows
        anchors { left: parent.left; right: parent.right; top: parent.top }
        columns: 2
        spacing: Theme.size.spacing
        SettingRow {
            objectName: "scannerPrefix"
            level: Access.Service
            width: section.half
            label: qsTr("Prefix")
            value: Scan.enabled ? Scan.prefix : qsTr("no scanner")
            onClicked: {
                if (!Access.ask(Access.Service))
                    return
                Frame.open("Parts/TextSheet", {
                    title: qsTr("Prefix of the scanner"), text: Scan.prefix, level: Access.Service, check: text => Scan.prefixProblem(text), onAccepted: text => Scan.setPrefix(text)
                })
            }
        }
        SettingTile {
            objectName: "scannerSuffix"
            width: section.half
            name: "scanner.suffix"
            heading: qsTr("Suffix of the scanner")
        }
        SettingTile {
            objectName: "scannerKeyTime"
            width: section.half
            name: "scanner.key_time_ms"
        }
        SettingRow {
            objectName: "scannerLast"
            width: section.half
            enabled: false
            mark: ""
            label: qsTr("Last code")
            value: Scan.enabled && Scan.lastCode.length > 0 ? Scan.lastCode : Theme.unknownText
        }
    }
    Label {
        objectName: "scannerText"
        anchors { left: parent.left; right: parent.right; top: rows.bottom; topMargin: Theme.size.spacing; bottom: parent.bottom }
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Scan.enabled ? qsTr("Scan a code to test the scanner. While this section is open, a code opens no recipe.")
            : qsTr("Set the scanner to send a prefix that nobody types before each code, such as ~~, and enter the same prefix here.")
        color: Theme.color.secondaryInk
    }
}
