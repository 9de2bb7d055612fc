// SPDX-License-Identifier: Apache-2.0
// The audit trail: rows newest first, filtered by user and area; one row in full; the state of the chain; the export.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    property string mode: "list"           // or "who", "area", "detail"
    signal filterRequested()

    readonly property var choices: sheet.mode === "who" ? Audit.names : Audit.areas
    readonly property bool chooses: sheet.mode === "who" || sheet.mode === "area"

    function choose(key: string): void {
        if (sheet.mode === "who")
            Audit.who = key
        else
            Audit.area = key
        sheet.mode = "list"
    }

    title: sheet.mode === "detail" ? Audit.detailTitle : qsTr("Audit trail")
    Component.onCompleted: Audit.open()

    Item {
        anchors.fill: parent
        visible: sheet.mode === "list"

        Row {
            id: filters
            anchors { left: parent.left; right: parent.right; top: parent.top }
            spacing: Theme.size.spacing
            readonly property real quarter: (width - 3 * spacing) / 4
            SettingRow {
                objectName: "auditWho"
                width: filters.quarter
                label: qsTr("User")
                value: Audit.who.length > 0 ? Audit.who : qsTr("All users")
                onClicked: sheet.mode = "who"
            }
            SettingRow {
                objectName: "auditArea"
                width: filters.quarter
                label: qsTr("Action")
                value: Audit.areaText
                onClicked: sheet.mode = "area"
            }
            Button {
                objectName: "auditFilter"
                width: filters.quarter
                glyph: Theme.icon.filter
                text: qsTr("Filter")
                onClicked: sheet.filterRequested()
            }
            Button {
                objectName: "auditExport"
                level: Access.Operator
                width: filters.quarter
                glyph: Theme.icon.save
                text: qsTr("CSV")
                enabled: Audit.log.rows.count > 0 && !Audit.log.csv.busy
                onClicked: {
                    if (!Access.ask(Access.Operator))
                        return
                    Audit.log.csv.make(Maintenance.files)
                    Frame.open("Parts/ReportFilesSheet", { title: qsTr("Audit trail as CSV"), note: Audit.log.filter.summary })
                }
            }
        }
        LogFilterStrip {
            id: strip
            anchors { left: parent.left; right: parent.right; top: filters.bottom; topMargin: Theme.size.spacing }
            filter: Audit.log.filter
        }
        Label {
            objectName: "auditEmpty"
            anchors { left: parent.left; right: parent.right; top: strip.visible ? strip.bottom : filters.bottom; topMargin: Theme.size.padding }
            visible: Audit.log.rows.count === 0 && !Audit.log.loading
            wrapMode: Text.WordWrap
            text: Audit.log.filter.active ? qsTr("No entry matches the filter.")
                : qsTr("There are no entries of this kind. Commands, downloads, parameters, settings and logins are recorded here.")
            color: Theme.color.secondaryInk
        }
        ListView {
            id: list
            objectName: "auditList"
            anchors { left: parent.left; right: parent.right; top: strip.visible ? strip.bottom : filters.bottom; bottom: chain.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
            clip: true
            spacing: Theme.size.outline
            boundsBehavior: Flickable.StopAtBounds
            model: Audit.log.rows
            delegate: AuditRow {
                required property int index
                objectName: "audit" + index
                onClicked: {
                    Audit.select(index)
                    sheet.mode = "detail"
                }
            }
        }
        ScrollMark { view: list }
        Row {
            id: chain
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            spacing: Theme.size.spacing
            IconLabel {
                id: chainIcon
                anchors.verticalCenter: parent.verticalCenter
                code: Audit.broken ? Theme.icon.alert : Audit.checking ? Theme.icon.unknown : Theme.icon.good
                color: Audit.broken ? Theme.color.fault : Theme.color.secondaryInk
            }
            Label {
                objectName: "auditChain"
                anchors.verticalCenter: parent.verticalCenter
                width: parent.width - chainIcon.width - parent.spacing
                wrapMode: Text.WordWrap
                text: Audit.chainText
                color: Audit.broken ? Theme.color.fault : Theme.color.secondaryInk
            }
        }
    }
    ListView {
        id: picker
        anchors.fill: parent
        visible: sheet.chooses
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.chooses ? sheet.choices : []
        delegate: ChoiceRow {
            required property var modelData
            objectName: "choice_" + modelData.key
            text: modelData.text
            holds: modelData.key === (sheet.mode === "who" ? Audit.who : Audit.area)
            onClicked: sheet.choose(modelData.key)
        }
    }
    ScrollMark {
        view: picker
        opacity: sheet.chooses ? 1 : 0
    }
    AuditDetail {
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: back.top; bottomMargin: Theme.size.spacing }
        visible: sheet.mode === "detail"
    }
    Button {
        id: back
        objectName: "auditBack"
        anchors { right: parent.right; bottom: parent.bottom }
        visible: sheet.mode === "detail"
        text: qsTr("Back to the list")
        onClicked: sheet.mode = "list"
    }
}
