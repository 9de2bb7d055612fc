// SPDX-License-Identifier: Apache-2.0
// The versions of software and program that run here, and how long the disk lasts.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

SettingsSection {
    id: section

    title: qsTr("Versions and disk")

    Flickable {
        id: scroll
        objectName: "versionsScroll"
        anchors { fill: parent; topMargin: section.bodyTop }
        contentHeight: column.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds

        Column {
            id: column
            width: scroll.width - 2 * Theme.size.accent
            spacing: Theme.size.spacing
            Label {
                objectName: "diskWarning"
                width: parent.width
                visible: text.length > 0
                wrapMode: Text.Wrap
                text: Versions.warning
                color: Theme.color.warning
                font.weight: Font.DemiBold
            }
            Repeater {
                model: Versions.rows
                Column {
                    id: row
                    required property int index
                    required property string label
                    required property string value
                    required property bool notable
                    width: column.width
                    Label {
                        width: parent.width
                        text: row.label
                        color: Theme.color.secondaryInk
                        font.pixelSize: Theme.size.caption
                    }
                    Label {
                        objectName: "version" + row.index
                        width: parent.width
                        wrapMode: Text.Wrap
                        text: row.value
                        color: row.notable ? Theme.color.warning : Theme.color.ink
                        font.weight: Font.DemiBold
                    }
                }
            }
        }
    }
    ScrollMark { view: scroll }
}
