// SPDX-License-Identifier: Apache-2.0
// Files or places on a USB stick or in the panel's own folder: a list, the consequence of the selected one below it, and the
// key that acts on it. Searches again until something usable is selected, to find a stick when it is plugged in.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property FileExchange exchange
    required property RowModel offers
    required property string actionText
    property int level       // of the person who may act on a row; 0: everybody
    property string allText  // of a second key that takes all; empty: there is none
    // The texts below the list while nothing is selected.
    property string chooseText: qsTr("Choose a file to view its content.")
    property string emptyText: chooseText
    property string workText // while the key's work is done; empty: the message stays
    // The height above the list for a choice of the sheet's own.
    property real headHeight: 0

    property int chosen: -1
    property string chosenDetail
    property bool chosenUsable
    property bool works: false

    signal accepted(int row)
    signal allAccepted()

    onCountChanged: sheet.chosen = -1 // the rows have moved

    readonly property int count: sheet.offers.count
    readonly property string hint: sheet.exchange.busy ? qsTr("Searching …") : sheet.count > 0 ? sheet.chooseText : sheet.emptyText

    Timer {
        interval: Theme.lookAgainTime
        repeat: true
        running: (sheet.chosen < 0 || !sheet.chosenUsable) && !sheet.exchange.busy
        onTriggered: sheet.exchange.refresh()
    }
    ListView {
        id: list
        objectName: "offers"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: goButton.top; topMargin: sheet.headHeight; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.offers
        delegate: ChoiceRow {
            required property int index
            required property string title
            required property string detail
            required property bool usable
            required note
            objectName: "offer" + index
            text: title
            noteLabel.color: usable || holds ? Theme.color.secondaryInk : Theme.color.fault
            holds: sheet.chosen === index
            onHoldsChanged: show()
            onDetailChanged: show()
            onUsableChanged: show()
            onClicked: {
                sheet.chosen = index
                sheet.works = false
            }

            function show(): void {
                if (!holds)
                    return
                sheet.chosenDetail = detail
                sheet.chosenUsable = usable
            }
        }
    }
    ScrollMark { view: list }
    Label {
        objectName: "offerDetail"
        anchors { left: parent.left; right: allButton.visible ? allButton.left : goButton.left; rightMargin: Theme.size.padding; top: goButton.top; bottom: parent.bottom }
        wrapMode: Text.Wrap
        fontSizeMode: Text.Fit
        readonly property bool isResult: sheet.exchange.message.length > 0
        text: sheet.chosen >= 0 ? sheet.chosenDetail : sheet.works && sheet.exchange.busy && sheet.workText.length > 0 ? sheet.workText
            : isResult ? sheet.exchange.message : sheet.hint
        color: sheet.chosen >= 0 ? (sheet.chosenUsable ? Theme.color.ink : Theme.color.fault)
            : sheet.exchange.failed ? Theme.color.fault : isResult ? Theme.color.ink : Theme.color.secondaryInk
    }
    Button {
        id: allButton
        objectName: "offerAll"
        level: sheet.level
        anchors { right: goButton.left; rightMargin: Theme.size.spacing; bottom: parent.bottom }
        visible: sheet.allText.length > 0
        enabled: !sheet.exchange.busy
        text: sheet.allText
        onClicked: sheet.allAccepted()
    }
    Button {
        id: goButton
        objectName: "offerGo"
        level: sheet.level
        anchors { right: parent.right; bottom: parent.bottom }
        kind: Button.Primary
        enabled: sheet.chosen >= 0 && sheet.chosenUsable && !sheet.exchange.busy
        text: sheet.actionText
        onClicked: {
            const row = sheet.chosen
            sheet.chosen = -1
            sheet.works = true
            sheet.accepted(row)
        }
    }
}
