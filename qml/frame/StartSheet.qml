// SPDX-License-Identifier: Apache-2.0
// The question at Start while another recipe is open than the machine would run. Its Start is held like the one beside it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    signal started()

    title: qsTr("Start")
    panelWidth: width * 0.86
    panelHeight: 2.5 * Theme.size.touch + Theme.size.commandKey + 4 * Theme.size.padding

    Label {
        objectName: "startQuestion"
        anchors.fill: parent
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: Theme.fill(qsTr("Start runs %1. Download %2 instead?"), [ProgramNames.active, ProgramNames.open])
        font.pixelSize: Theme.size.title
    }
    footer: [
        Button {
            objectName: "startCancel"
            height: Theme.size.commandKey
            text: qsTr("Cancel")
            onClicked: sheet.closed()
        },
        Button {
            objectName: "startDownload"
            width: Math.min(implicitWidth, 0.32 * sheet.width)
            height: Theme.size.commandKey
            glyph: Theme.icon.download
            text: qsTr("Download")
            note: ProgramNames.open
            onClicked: Frame.open("Download/DownloadSheet", {})
        },
        CommandKey {
            objectName: "startActive"
            level: Access.Operator
            width: 0.3 * sheet.width
            small: true
            glyph: Theme.icon.start
            text: Theme.fill(qsTr("Start %1"), [ProgramNames.active])
            ready: Controller.canStart
            holdMs: Settings.startIsHeld ? Theme.holdTime : 0
            onCommanded: {
                sheet.started()
                sheet.closed()
            }
        }
    ]
}
