// SPDX-License-Identifier: Apache-2.0
// The address of a network port of this computer: by DHCP, or fixed. Nothing changes before Apply.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property var ports: SystemNetwork.ports
    readonly property var fields: SystemNetwork.fields
    readonly property bool several: ports.length > 1
    readonly property string complaint: SystemNetwork.refusal.length > 0 ? SystemNetwork.refusal : SystemNetwork.problem
    signal portRequested()
    signal fieldRequested(int field)

    pending: SystemNetwork.editable && SystemNetwork.edited
    title: qsTr("Network")
    note: SystemNetwork.stateText
    onClosed: SystemNetwork.discard()      // the entry of an address, and a logout meanwhile, keep the others
    Component.onCompleted: SystemNetwork.watched = true
    Component.onDestruction: SystemNetwork.watched = false

    Flickable {
        id: list
        anchors.fill: parent
        contentHeight: rows.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: rows
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing
            Row {
                width: parent.width
                spacing: Theme.size.spacing
                SettingRow {
                    id: portRow
                    objectName: "networkPort"
                    visible: sheet.several
                    width: (rows.width - parent.spacing) / 2
                    enabled: !SystemNetwork.busy
                    label: qsTr("Network port")
                    value: SystemNetwork.port
                    onClicked: sheet.portRequested()
                }
                Segmented {
                    width: sheet.several ? portRow.width : rows.width
                    enabled: SystemNetwork.editable
                    choices: [{ key: false, text: qsTr("By DHCP"), name: "networkDhcp" }, { key: true, text: qsTr("Fixed"), name: "networkFixed" }]
                    current: SystemNetwork.fixed ? true : SystemNetwork.dhcp ? false : null
                    onChosen: key => SystemNetwork.fixed = key
                }
            }
            Grid {
                id: grid
                columns: 2
                spacing: Theme.size.spacing
                Repeater {
                    model: sheet.fields.length
                    SettingRow {
                        required property int index
                        readonly property var field: sheet.fields[index]
                        objectName: "networkField" + index
                        width: (rows.width - grid.spacing) / 2
                        enabled: SystemNetwork.editable && SystemNetwork.fixed
                        label: field.label
                        value: field.text.length > 0 ? field.text : Theme.unknownText
                        mark: enabled ? Theme.icon.next : ""
                        onClicked: sheet.fieldRequested(index)
                    }
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    footer: [
        Label {
            objectName: "networkProblem"
            width: sheet.width - applyKey.width - 6 * Theme.size.padding
            height: Theme.size.touch
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: sheet.complaint
            color: Theme.color.fault
        },
        Button {
            id: applyKey
            objectName: "networkApply"
            level: Access.Service
            width: Math.max(implicitWidth, 2 * Theme.size.touch)
            kind: Button.Primary
            text: SystemNetwork.editable && !SystemNetwork.edited ? qsTr("In use") : qsTr("Apply")
            enabled: SystemNetwork.editable && SystemNetwork.edited && SystemNetwork.refusal.length === 0
            onClicked: SystemNetwork.apply()
        }
    ]
}
