// SPDX-License-Identifier: Apache-2.0
// The values of the machine's program that are outside their approved windows: by whom, since when, why. Without a reason a key
// asks for it.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: line

    readonly property WindowReason reasons: Editor.programDownload.windowReason

    implicitHeight: reasons.unexplained ? Theme.size.touch : words.implicitHeight
    visible: words.text.length > 0

    IconLabel {
        id: mark
        anchors { left: parent.left; verticalCenter: parent.verticalCenter }
        code: Theme.icon.alert
        color: Theme.color.warning
        font.pixelSize: Theme.size.body
    }
    Label {
        id: words
        objectName: "windowLine"
        anchors { left: mark.right; leftMargin: Theme.size.accent; right: key.visible ? key.left : parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        wrapMode: Text.WordWrap
        maximumLineCount: 2
        elide: Text.ElideRight
        text: Theme.unbroken(line.reasons.line)
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Button {
        id: key
        objectName: "windowReason"
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        visible: line.reasons.unexplained
        text: qsTr("Give a reason …")
        onClicked: Frame.open("Download/WindowReasonSheet", {})
    }
}
