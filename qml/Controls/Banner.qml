// SPDX-License-Identifier: Apache-2.0
// A sentence that the operator must see, with an icon and a button; severity by color and icon.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

Rectangle {
    id: banner
    Accessible.role: Accessible.AlertMessage
    Accessible.name: banner.text

    enum Severity { Information, Warning, Fault }

    required property string text
    property int severity: Banner.Information
    property string buttonText
    property string wayText                // text of a second button for details; "" for none
    property int wayLevel                  // of the person who may press it; 0: everybody
    signal accepted()
    signal wayChosen()

    readonly property color accentColor: severity === Banner.Fault ? Theme.color.fault
        : severity === Banner.Warning ? Theme.color.warning : Theme.color.touch

    radius: Theme.size.radius
    color: Theme.color.surface
    border { width: Theme.size.outline; color: accentColor }

    MouseArea { anchors.fill: parent }
    IconLabel {
        id: mark
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
        code: banner.severity === Banner.Fault ? Theme.icon.fault
            : banner.severity === Banner.Warning ? Theme.icon.alert : Theme.icon.information
        color: banner.accentColor
    }
    Label {
        objectName: "bannerText"
        anchors { left: mark.right; right: way.visible ? way.left : button.left; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
        height: parent.height - Theme.size.spacing
        text: banner.text
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
    }
    Button {
        id: way
        objectName: "bannerWay"
        level: banner.wayLevel
        anchors { right: button.left; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: banner.wayText.length > 0
        width: button.width
        text: banner.wayText
        onClicked: banner.wayChosen()
    }
    Button {
        id: button
        objectName: "bannerButton"
        anchors { right: parent.right; rightMargin: Theme.size.spacing + Theme.size.outline; verticalCenter: parent.verticalCenter }
        width: Math.max(Theme.size.touch, Math.round(5.5 * Theme.size.body))   // the same for each text: a second tap on one spot is the same key
        text: banner.buttonText
        onClicked: banner.accepted()
    }
}
