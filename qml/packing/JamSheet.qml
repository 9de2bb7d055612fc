// SPDX-License-Identifier: Apache-2.0
// The knife's torque over the angle of its shaft with the band that the controller has learned, the state of the monitoring
// in words, and the last jam.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel
import CamPanel.Plot

Sheet {
    id: sheet

    readonly property JamWatch jam: Maintenance.packing.jam
    readonly property bool empty: jam.emptyText.length > 0

    title: qsTr("Jams at the jaws")
    note: sheet.empty ? "" : qsTr("Torque of the knife in per cent of its rated torque, over the angle of its shaft from the cut.")
    Component.onCompleted: sheet.jam.watched = true
    Component.onDestruction: sheet.jam.watched = false

    component Words: Column {
        id: words
        required property string name
        required property string caption
        required property string text
        property bool abnormal
        width: parent.width
        Label {
            width: parent.width
            wrapMode: Text.WordWrap
            text: words.caption
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            objectName: words.name
            width: parent.width
            wrapMode: Text.WordWrap
            text: words.text
            color: words.abnormal ? Theme.color.warning : Theme.color.ink
        }
    }
    component Key: Row {
        id: key
        required property string text
        property alias sign: sign.data
        spacing: Theme.size.spacing
        Item {
            id: sign
            anchors.verticalCenter: parent.verticalCenter
            width: Theme.size.icon
            height: Theme.size.caption
        }
        Label {
            anchors.verticalCenter: parent.verticalCenter
            text: key.text
            font.pixelSize: Theme.size.caption
        }
    }

    Label {
        objectName: "jamEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: sheet.empty
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: sheet.jam.emptyText
        color: Theme.color.secondaryInk
    }
    BandPlot {
        id: plot
        objectName: "jamPlot"
        Accessible.role: Accessible.Graphic
        Accessible.name: sheet.title
        Accessible.description: sheet.jam.stateText
        anchors { left: parent.left; right: sentences.left; rightMargin: Theme.size.padding; top: parent.top; bottom: legend.top; bottomMargin: Theme.size.spacing }
        visible: !sheet.empty
        expected: sheet.jam.expected
        halfWidths: sheet.jam.halfWidths
        readings: sheet.jam.readings
        jam: sheet.jam.jam
        from: sheet.jam.fromDeg
        to: sheet.jam.toDeg
        closing: sheet.jam.closingDeg
        cutLabel: qsTr("cut")
        closingLabel: qsTr("closes")
        axisFont: Theme.captionFont
        lineWidth: Theme.size.outline
        gridColor: Theme.color.line
        secondaryInkColor: Theme.color.secondaryInk
        bandColor: Theme.color.touchTint
        expectedColor: Theme.color.target
        readingColor: Theme.color.touch
        jamColor: Theme.color.warning
        Binding {
            target: plot
            property: "locale"
            value: Theme.locale
        }
    }
    Flow {
        id: legend
        anchors { left: parent.left; right: plot.right; bottom: parent.bottom }
        visible: !sheet.empty
        spacing: Theme.size.padding
        Key {
            text: qsTr("learned band")
            sign: Rectangle {
                anchors.fill: parent
                color: Theme.color.touchTint
                Rectangle {
                    anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
                    height: Theme.size.outline
                    color: Theme.color.target
                }
            }
        }
        Key {
            text: qsTr("readings")
            sign: Rectangle {
                anchors.centerIn: parent
                width: Math.round(parent.height / 2)
                height: width
                radius: width / 2
                color: Theme.color.touch
            }
        }
        Key {
            visible: !isNaN(sheet.jam.jam.x)
            text: qsTr("last jam")
            sign: IconLabel {
                anchors.centerIn: parent
                code: Theme.icon.close
                color: Theme.color.warning
                font.pixelSize: Theme.size.caption
            }
        }
    }
    Column {
        id: sentences
        anchors { right: parent.right; top: parent.top }
        visible: !sheet.empty
        width: Math.round(parent.width * 0.44)
        spacing: Theme.size.spacing
        Words {
            name: "jamState"
            caption: qsTr("Monitoring of the torque, reported every %1").arg(sheet.jam.intervalText)
            text: sheet.jam.stateText
            abnormal: sheet.jam.blind
        }
        Words {
            name: "jamLast"
            caption: qsTr("Last jam; jams since power-up: %1").arg(sheet.jam.countText)
            text: sheet.jam.lastText
        }
        Words {
            name: "jamResidue"
            caption: qsTr("Residue on the knife")
            text: sheet.jam.residueText
        }
    }
}
