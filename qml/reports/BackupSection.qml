// SPDX-License-Identifier: Apache-2.0
// Exports to a stick: backup and restore of all the panel's data, the commissioning report, and the archive for the
// manufacturer's support.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

MaintenanceSection {
    id: section

    readonly property real keyWidth: Math.max(backupRow.naturalKeyWidth, restoreRow.naturalKeyWidth, reportRow.naturalKeyWidth, bundleRow.naturalKeyWidth)

    function chooseBackup(): void {
        if (!Access.ask(Access.Service))
            return
        Backup.scan()
        Frame.open("Parts/OfferSheet", {
            title: qsTr("Restore a backup"), exchange: Backup, offers: Backup.found, level: Access.Service, workText: qsTr("Checking …"), actionText: qsTr("Check and restore"),
            emptyText: qsTr("There is no backup on a USB stick or on this panel. Plug a stick in; the panel finds it automatically."),
            onAccepted: row => Backup.check(row)
        })
    }

    Connections {
        target: Backup
        enabled: section.visible
        function onOffered() { Frame.open("Parts/ReportFilesSheet", { title: qsTr("Location of the backup"), files: Backup.places }) }
        function onChecked() {
            Frame.open("Parts/ConfirmSheet", {
                title: qsTr("Restore this backup?"), panelHeight: 6 * Theme.size.touch, question: Backup.question,
                ways: [{ key: "restore", text: qsTr("Restore"), primary: true, level: Access.Service }], onChosen: () => Backup.restore()
            })
        }
    }
    Connections {
        target: ServiceBundle
        enabled: section.visible
        function onOffered() { Frame.open("Parts/ReportFilesSheet", { title: qsTr("Location of the service bundle") }) }
    }
    Column {
        id: rows
        anchors { left: parent.left; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        TaskRow {
            id: backupRow
            width: rows.width
            title: qsTr("Backup")
            note: qsTr("All data of this panel in one file: recipes with their versions, machine data, users, alarms, audit trail, bags, trends, settings.")
            action: qsTr("Create backup")
            name: "backupMake"
            level: Access.Service
            glyph: Theme.icon.save
            keyWidth: section.keyWidth
            usable: !Backup.busy
            onClicked: Backup.make()
        }
        TaskRow {
            id: restoreRow
            width: rows.width
            title: qsTr("Restore")
            note: qsTr("Replaces all these data by a backup. The file is checked first, and the present data are saved as a backup.")
            action: qsTr("Choose file")
            name: "backupRestore"
            level: Access.Service
            glyph: Theme.icon.undo
            keyWidth: section.keyWidth
            usable: !Backup.busy
            onClicked: section.chooseBackup()
        }
        TaskRow {
            id: reportRow
            width: rows.width
            title: qsTr("Commissioning report")
            note: qsTr("PDF with the open recipe (curves, limits, table), machine data, controller program and last bags.")
            action: qsTr("Create report")
            name: "reportMake"
            level: Access.Operator
            glyph: Theme.icon.save
            keyWidth: section.keyWidth
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                Commissioning.offer()
                Frame.open("Parts/ReportFilesSheet", { title: qsTr("Location of the report") })
            }
        }
        TaskRow {
            id: bundleRow
            width: rows.width
            title: qsTr("Service bundle")
            note: qsTr("For the manufacturer's support: open recipe, table, controller, alarms and changes of 7 days, communication, the last 10 seconds. No PINs.")
            action: qsTr("Create bundle")
            name: "bundleMake"
            level: Access.Operator
            glyph: Theme.icon.save
            keyWidth: section.keyWidth
            usable: !ServiceBundle.busy
            onClicked: if (Access.ask(Access.Operator)) ServiceBundle.make()
        }
    }
    Label {
        objectName: "backupMessage"
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; top: rows.bottom; topMargin: Theme.size.spacing }
        verticalAlignment: Text.AlignBottom
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        text: Backup.busy ? qsTr("Working …") : Backup.message
        color: Backup.failed ? Theme.color.fault : Theme.color.secondaryInk
    }
}
