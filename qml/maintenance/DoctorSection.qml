// SPDX-License-Identifier: Apache-2.0
// The link doctor: the present error, diagnosis, search, and one tap to use the connection found.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property LinkDoctor doctor: Maintenance.doctor

    IconLabel {
        id: mark
        anchors { left: parent.left; verticalCenter: state.verticalCenter }
        code: Controller.connection === Controller.Connection.Connected ? Theme.icon.linkUp : Theme.icon.linkDown
        color: Theme.color.secondaryInk
    }
    Label {
        id: state
        objectName: "doctorState"
        anchors { left: mark.right; leftMargin: Theme.size.spacing; right: parent.right; top: parent.top }
        wrapMode: Text.WordWrap
        text: section.doctor.running ? section.doctor.triedText : Controller.connectionText
        font.weight: Font.DemiBold
    }
    Column {
        id: run
        anchors { left: parent.left; right: parent.right; top: state.bottom; topMargin: Theme.size.spacing }
        spacing: Theme.size.spacing
        ProgressBar {
            width: parent.width
            visible: section.doctor.running
            progress: section.doctor.progress
        }
        Label {
            objectName: "doctorProgress"
            width: parent.width
            visible: section.doctor.running
            text: section.doctor.progressText
        }
        Label {
            objectName: "doctorResult"
            width: parent.width
            wrapMode: Text.WordWrap
            text: section.doctor.resultText
            color: section.doctor.canTake ? Theme.color.good : Theme.color.secondaryInk
        }
    }
    ListView {
        id: list
        objectName: "doctorFindings"
        anchors { left: parent.left; right: parent.right; top: run.bottom; bottom: reason.visible ? reason.top : foot.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: section.doctor.findings
        delegate: FindingRow {
            width: list.width - 2 * Theme.size.accent // always: its height follows from its width
        }
    }
    ScrollMark { view: list }
    Label {
        id: reason
        objectName: "doctorBlocked"
        anchors { left: parent.left; right: parent.right; bottom: foot.top; bottomMargin: Theme.size.spacing }
        visible: !section.doctor.running && section.doctor.blockedReason.length > 0
        wrapMode: Text.WordWrap
        text: section.doctor.blockedReason
        color: Theme.color.warning
    }
    Row {
        id: foot
        readonly property int keys: section.doctor.canTake ? 3 : 2
        readonly property real keyWidth: (width - (keys - 1) * spacing) / keys
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        spacing: Theme.size.spacing
        Button {
            objectName: "doctorDiagnose"
            level: Access.Operator
            width: foot.keyWidth
            visible: !section.doctor.running
            enabled: section.doctor.canBegin
            text: qsTr("Diagnose")
            onClicked: section.doctor.diagnose()
        }
        Button {
            objectName: "doctorSearch"
            level: Access.Operator
            width: foot.keyWidth
            visible: !section.doctor.running
            enabled: section.doctor.canBegin
            text: qsTr("Search")
            note: qsTr("for the controller")
            onClicked: section.doctor.search()
        }
        Button {
            objectName: "doctorTake"
            level: Access.Technician
            width: foot.keyWidth
            visible: section.doctor.canTake
            kind: Button.Primary
            text: qsTr("Use this")
            note: qsTr("connection")
            onClicked: section.doctor.take()
        }
        Button {
            objectName: "doctorCancel"
            level: Access.Operator
            width: foot.width
            visible: section.doctor.running
            glyph: Theme.icon.close
            text: qsTr("Cancel")
            onClicked: section.doctor.cancel()
        }
    }
}
