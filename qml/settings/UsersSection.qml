// SPDX-License-Identifier: Apache-2.0
// Access: the users with their levels, login and logout, and the audit trail.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Access
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property real half: (width - Theme.size.spacing) / 2
    readonly property var people: Access.users

    title: qsTr("Users")
    Component.onCompleted: Access.clearMessage()

    function openUser(id: int): void {
        if (Access.ask(Access.Service))
            Frame.open("Access/UserSheet", { userId: id, onPinRequested: () => section.enterPin(id) })
    }
    function enterPin(id: int): void {
        Frame.open("Access/NewPinSheet", {
            title: qsTr("New PIN"), level: section.people.find(each => each.id === id)?.level ?? Access.Service,
            onEntered: pin => Access.changePin(id, pin)
        })
    }
    function openAudit(): void {
        Frame.open("Audit/AuditSheet", { onFilterRequested: () => filterDialogs.open() })
    }

    NewUser { id: newUser }
    LogFilterDialogs {
        id: filterDialogs
        filter: Audit.log.filter
        idLabel: qsTr("Row or register")
        onClosed: section.openAudit()
    }
    Item {
        id: now
        anchors { left: parent.left; right: parent.right; top: parent.top; topMargin: section.bodyTop }
        height: Access.protectedByPins ? Theme.size.touch : nobody.height
        Label {
            id: nobody
            objectName: "usersNobody"
            visible: !Access.protectedByPins
            width: parent.width
            wrapMode: Text.WordWrap
            text: qsTr("No PIN is set: all users have full access until the first user is added. Viewing and Stop never need a login.")
            color: Theme.color.secondaryInk
        }
        Column {
            visible: Access.protectedByPins
            anchors { left: parent.left; right: loginButton.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
            Label {
                objectName: "usersNow"
                width: parent.width
                fontSizeMode: Text.HorizontalFit
                text: Access.loggedIn ? Theme.fill(qsTr("%1 · %2"), [Access.userName, Access.levelText]) : qsTr("Nobody logged in · %1").arg(Access.levelText)
                font.weight: Font.DemiBold
            }
            Label {
                objectName: "usersMessage"
                width: parent.width
                height: Theme.size.touch - 2 * Theme.size.title
                wrapMode: Text.WordWrap
                fontSizeMode: Text.Fit
                text: Access.message.length > 0 ? Access.message : Access.permissionText(Access.level)
                color: Access.failed ? Theme.color.fault : Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
        Button {
            id: loginButton
            objectName: "usersLogin"
            visible: Access.protectedByPins
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            glyph: Access.loggedIn ? Theme.icon.logOut : Theme.icon.logIn
            text: Access.loggedIn ? qsTr("Log out") : qsTr("Log in")
            onClicked: Access.loggedIn ? Access.logOut() : Access.loginRequested(Access.Viewer)
        }
    }
    Flickable {
        id: list
        objectName: "usersList"
        anchors { left: parent.left; right: parent.right; top: now.bottom; bottom: foot.top; topMargin: Theme.size.spacing; bottomMargin: Theme.size.spacing }
        contentHeight: rows.height
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        Column {
            id: rows
            width: list.width - scrollMark.room
            spacing: Theme.size.spacing
            Repeater {
                model: section.people
                ListRow {
                    required property var modelData
                    objectName: "user_" + modelData.name
                    level: Access.Service
                    width: rows.width
                    text: modelData.name
                    note: modelData.levelText
                    holds: modelData.current
                    onClicked: section.openUser(modelData.id)
                }
            }
        }
    }
    ScrollMark { id: scrollMark; view: list }
    Grid {
        id: foot
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        columns: 2
        spacing: Theme.size.spacing
        SettingTile {
            objectName: "autoLogout"
            visible: Access.protectedByPins
            width: section.half
            name: "access.auto_logout_minutes"
            heading: qsTr("Logout without touch after")
        }
        SettingTile {
            objectName: "withoutLogin"
            visible: Access.protectedByPins
            width: section.half
            name: "access.operators_log_in"
            value: field.key ? qsTr("view and stop") : qsTr("operate")
            choices: [{ key: false, text: qsTr("Operate"), note: Access.permissionText(Access.Operator) },
                { key: true, text: qsTr("View and stop"), note: qsTr("operators must log in") }]
        }
        ListRow {
            objectName: "auditButton"
            width: section.half
            text: qsTr("Audit trail")
            note: qsTr("Record of changes")
            onClicked: section.openAudit()
        }
        Button {
            objectName: "userAdd"
            level: Access.Service
            width: section.half
            kind: Access.protectedByPins ? Button.Normal : Button.Primary
            glyph: Theme.icon.addUser
            text: Access.protectedByPins ? qsTr("Add a user") : qsTr("First user")
            onClicked: if (Access.ask(Access.Service)) newUser.add()
        }
    }
}
