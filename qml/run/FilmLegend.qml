// SPDX-License-Identifier: Apache-2.0
// The legend of the picture of the film.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Item {
    id: legend

    implicitHeight: grid.implicitHeight

    component Key: Item {
        id: key
        required property string text
        default property alias sign: place.data
        width: legend.width / 2
        height: Math.round(Theme.size.body * 1.8)
        Item {
            id: place
            width: Theme.size.icon
            height: Theme.size.body
            anchors.verticalCenter: parent.verticalCenter
        }
        Label {
            anchors { left: place.right; leftMargin: Theme.size.spacing; right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            wrapMode: Text.WordWrap
            fontSizeMode: Text.HorizontalFit
            lineHeight: lineCount > 1 ? 0.8 : 1
            text: key.text
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
    }
    component Sign: Rectangle {
        x: parent ? (parent.width - width) / 2 : 0
        y: parent ? (parent.height - height) / 2 : 0
        width: Theme.size.accent
        height: parent ? parent.height : 0
    }

    Grid {
        id: grid
        columns: 2

        Key {
            text: qsTr("mark detected")
            Sign { color: Theme.color.ink }
        }
        Key {
            text: qsTr("missed mark, calculated")
            Sign {
                color: Theme.color.touchTint
                border { width: Theme.size.hairline; color: Theme.color.ink }
            }
        }
        Key {
            text: qsTr("next expected mark")
            Sign {
                width: Theme.size.mark
                color: Theme.color.touchTint
                border { width: Theme.size.outline; color: Theme.color.touch }
            }
        }
        Key {
            text: qsTr("product")
            Sign {
                width: parent.width
                radius: Theme.size.accent
                color: Theme.color.sync
            }
        }
        Key {
            text: qsTr("next cut")
            Sign {
                width: Theme.size.outline
                color: Theme.color.ink
            }
        }
        Key {
            text: qsTr("skipped cut")
            IconLabel {
                anchors.centerIn: parent
                code: Theme.icon.close
                color: Theme.color.warning
                font.pixelSize: Theme.size.body
            }
        }
    }
}
