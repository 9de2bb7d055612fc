// SPDX-License-Identifier: Apache-2.0
// The versions of CamPanel on a stick, and the key that puts the version before back.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Parts

OfferSheet {
    id: sheet

    readonly property bool hasWayBack: SoftwareUpdate.backVersion.length > 0

    title: qsTr("Update")
    note: qsTr("Installed: CamPanel %1").arg(SoftwareUpdate.installedVersion || Qt.application.version)
    exchange: SoftwareUpdate
    offers: SoftwareUpdate.found
    level: Access.Service
    chooseText: qsTr("Choose a version.")
    emptyText: qsTr("There is no package of CamPanel on a USB stick. Plug a stick in; the panel finds it automatically.")
    actionText: SoftwareUpdate.actionOf(sheet.chosen)
    headHeight: hasWayBack ? back.height + Theme.size.spacing : 0
    // While an installation is being prepared, its message stays.
    Component.onCompleted: if (!SoftwareUpdate.busy) SoftwareUpdate.scan()
    onAccepted: row => SoftwareUpdate.choose(row)

    Label {
        anchors { left: parent.left; right: back.left; rightMargin: Theme.size.padding; top: parent.top }
        height: back.height
        visible: sheet.hasWayBack
        verticalAlignment: Text.AlignVCenter
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        text: SoftwareUpdate.blockedReason.length > 0 ? SoftwareUpdate.blockedReason : qsTr("The version before the last update is kept on this panel.")
        color: Theme.color.secondaryInk
    }
    Button {
        id: back
        objectName: "updateBack"
        level: Access.Service
        anchors { right: parent.right; top: parent.top }
        visible: sheet.hasWayBack
        enabled: SoftwareUpdate.blockedReason.length === 0 && !SoftwareUpdate.busy
        text: qsTr("Back to %1").arg(SoftwareUpdate.backVersion)
        onClicked: SoftwareUpdate.chooseBack()
    }
}
