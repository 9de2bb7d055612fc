// SPDX-License-Identifier: Apache-2.0
// The serial ports of this computer, with the reason for those that cannot be used.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    title: qsTr("Serial port")
    panelWidth: width * 0.8

    Label {
        anchors { left: parent.left; right: parent.right; top: parent.top }
        visible: list.count === 0
        wrapMode: Text.WordWrap
        text: qsTr("This computer has no serial port. Plug the adapter in and press Search again.")
        color: Theme.color.secondaryInk
    }
    ListView {
        id: list
        anchors.fill: parent
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: Settings.ports
        delegate: ChoiceRow {
            required property string name
            required property string description
            required property string problem
            level: Access.Technician
            text: name
            note: problem.length > 0 ? problem : description
            noteLabel.color: problem.length > 0 ? Theme.color.fault : Theme.color.secondaryInk
            holds: name === Settings.portName
            onClicked: {
                Settings.portName = name
                sheet.closed()
            }
        }
    }
    ScrollMark { view: list }
    footer: Button {
        glyph: Theme.icon.refresh
        text: qsTr("Search again")
        onClicked: Settings.refreshPorts()
    }
}
