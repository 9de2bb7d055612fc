// SPDX-License-Identifier: Apache-2.0
// Run without a program: the way to a first one.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Item {
    id: view

    property real bottomInset
    readonly property bool connected: Controller.connection === Controller.Connection.Connected

    Card {
        anchors { fill: parent; bottomMargin: view.bottomInset }
        Column {
            anchors.centerIn: parent
            width: parent.width - 4 * Theme.size.padding
            spacing: Theme.size.padding
            IconLabel {
                width: parent.width
                code: view.connected ? Theme.icon.download : Theme.icon.linkDown
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.largeIcon
            }
            Label {
                width: parent.width
                horizontalAlignment: Text.AlignHCenter
                wrapMode: Text.WordWrap
                objectName: "noProgramText"
                text: Editor.programDownload.busy ? Editor.programDownload.text : view.connected ? Controller.run.program : Controller.connectionText
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.title
            }
            Button {
                objectName: "downloadAgain"
                level: Access.Operator
                anchors.horizontalCenter: parent.horizontalCenter
                readonly property bool asks: Editor.programDownload.state === ProgramDownload.State.Unapproved   // the sheet does
                visible: view.connected && (Editor.programDownload.canDownload || asks)
                width: Math.max(implicitWidth, 3 * Theme.size.touch)
                height: Theme.size.commandKey
                kind: Button.Primary
                glyph: Theme.icon.download
                text: Editor.recipeVersion === 0 ? Theme.fill(qsTr("Download %1"), [Editor.recipeName])
                    : Editor.edited ? Theme.fill(qsTr("Download %1, edited"), [Editor.recipeName])
                    : Theme.fill(qsTr("Download %1 v%2"), [Editor.recipeName, Editor.recipeVersion])
                onClicked: asks ? Frame.open("Download/DownloadSheet", {}) : Editor.download()
            }
            Button {
                objectName: "openMotion"
                anchors.horizontalCenter: parent.horizontalCenter
                visible: view.connected
                width: Math.max(implicitWidth, 3 * Theme.size.touch)
                height: Theme.size.touch
                glyph: Theme.icon.motion
                text: qsTr("Open Motion")
                onClicked: Frame.openPage("motion")
            }
        }
    }
}
