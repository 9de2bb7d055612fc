// SPDX-License-Identifier: Apache-2.0
// A dialog over the page area: title, content, footer. The frame gives it a region that never contains Start and Stop.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Overlay {
    id: sheet

    required property string title
    property string note
    property bool covered                  // another sheet stands in its place
    property bool asked                    // whether what is pending is to be dropped
    default property alias content: body.data
    property alias header: headerRow.data  // keys beside the title
    property alias footer: footerRow.data
    readonly property real besideWidth: Math.max(Theme.size.sideColumn, Math.min(Theme.size.keypad, width / 2) - Theme.size.navigation - Theme.size.gap)
    property real panelWidth: beside ? besideWidth : width - 2 * Theme.size.gap
    property real panelHeight: height - 2 * Theme.size.gap

    // Closes it; what is pending is dropped by a second touch only.
    function close(): void {
        if (sheet.pending && !sheet.asked)
            sheet.asked = true
        else
            sheet.closed()
    }

    onPendingChanged: sheet.asked = false
    closeLeft: beside ? width : panel.x + closeButton.x
    besideRight: beside ? panel.x + panel.width : 0

    Rectangle {
        anchors.fill: parent
        visible: !sheet.beside && !sheet.covered
        color: Theme.color.scrim
    }
    MouseArea { // not over the navigation
        anchors { fill: parent; leftMargin: Theme.size.navigation }
        visible: !sheet.beside
    }
    Card {
        id: panel
        objectName: "sheetPanel"
        visible: !sheet.covered
        x: sheet.beside ? Theme.size.navigation + Theme.size.gap : Math.round((parent.width - width) / 2)
        y: Math.round((parent.height - height) / 2)
        width: Math.round(Math.min(sheet.panelWidth, sheet.width - 2 * Theme.size.gap))
        height: Math.min(sheet.panelHeight, sheet.height - 2 * Theme.size.gap)

        clip: true
        MouseArea { anchors.fill: parent }
        Column {
            anchors { left: parent.left; leftMargin: Theme.size.padding; right: headerRow.left; verticalCenter: closeButton.verticalCenter }
            Label {
                width: parent.width
                text: sheet.title
                fontSizeMode: Text.HorizontalFit
                minimumPixelSize: Theme.size.body
                wrapMode: Text.WordWrap    // below the smallest size
                font { pixelSize: Theme.size.title; bold: true }
            }
            Label {
                objectName: "sheetNote"
                readonly property string warning: sheet.asked ? qsTr("Not confirmed yet. Close again to discard the entry.") : sheet.warning
                visible: text.length > 0
                width: parent.width
                wrapMode: Text.WordWrap
                text: warning.length > 0 ? warning : sheet.note
                color: warning.length > 0 ? Theme.color.warning : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Row {
            id: headerRow
            objectName: "sheetHeader"
            anchors { right: closeButton.left; top: closeButton.top }
        }
        Button {
            id: closeButton
            objectName: "sheetClose"
            Accessible.name: qsTr("Close")
            anchors { right: parent.right; top: parent.top; margins: Theme.size.outline }
            kind: Button.Quiet
            glyph: Theme.icon.close
            onClicked: sheet.close()
        }
        Item {
            id: body
            anchors {
                left: parent.left; right: parent.right; top: closeButton.bottom
                bottom: footerRow.children.length > 0 ? footerRow.top : parent.bottom
                margins: Theme.size.padding; topMargin: 0
            }
        }
        Row {
            id: footerRow
            objectName: "sheetFooter"
            anchors { right: parent.right; bottom: parent.bottom; margins: Theme.size.padding }
            spacing: Theme.size.padding
        }
        // A key that the keypad would cut is covered wholly.
        Rectangle {
            readonly property Item cut: sheet.free > 0 ? footerRow.childAt(sheet.free - panel.x - footerRow.x, footerRow.height / 2) : null
            visible: cut !== null
            x: footerRow.x + (cut?.x ?? 0)
            y: footerRow.y
            width: cut?.width ?? 0
            height: footerRow.height
            color: panel.color
            MouseArea { anchors.fill: parent }
        }
    }
}
