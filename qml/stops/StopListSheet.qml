// SPDX-License-Identifier: Apache-2.0
// The stops of a shift, newest first; a tap opens the keys with the reasons.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    property bool answers
    readonly property ReasonKeys keys: Stops.shift.keys

    function back(): void {
        if (sheet.keys.groupText.length > 0)
            sheet.keys.close()
        else
            sheet.answers = false
    }

    title: sheet.answers ? qsTr("Reason of the stop") : qsTr("Stops")
    note: sheet.answers ? Stops.shift.selectedText : Stops.shift.title

    Connections {
        target: Stops.shift
        function onAnswered() { sheet.answers = false }
    }
    ListView {
        id: list
        objectName: "stopList"
        anchors.fill: parent
        visible: !sheet.answers
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: Stops.shift.stops
        delegate: StopListRow {
            required property int index
            objectName: "stop" + index
            level: Access.Operator
            onClicked: {
                if (!Access.ask(Access.Operator))
                    return
                Stops.shift.select(index)
                sheet.answers = true
            }
        }
    }
    ScrollMark {
        view: list
        opacity: sheet.answers ? 0 : 1
    }
    Label {
        objectName: "stopListEmpty"
        anchors.centerIn: parent
        visible: !sheet.answers && Stops.shift.stops.count === 0
        text: qsTr("No stop in this shift.")
        color: Theme.color.secondaryInk
    }
    ReasonGrid {
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: backKey.top; bottomMargin: Theme.size.spacing }
        visible: sheet.answers
        keys: sheet.keys
    }
    Button {
        id: backKey
        objectName: "stopListBack"
        anchors { right: parent.right; bottom: parent.bottom }
        visible: sheet.answers
        glyph: Theme.icon.previous
        text: qsTr("Back")
        onClicked: sheet.back()
    }
}
