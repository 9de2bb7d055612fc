// SPDX-License-Identifier: Apache-2.0
// The dialogs of the filter of a list of records: the filter, and the keyboard for its id and its word.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

Item {
    id: dialogs

    property Page page
    required property LogFilter filter
    required property string idLabel
    property Component back: null          // the sheet with the list; null: the list is on the page
    property string draft

    function open(): void { dialogs.page.sheetRequested(filterSheet) }

    Component {
        id: filterSheet
        LogFilterSheet {
            filter: dialogs.filter
            idLabel: dialogs.idLabel
            onIdRequested: dialogs.page.sheetRequested(idSheet)
            onWordRequested: dialogs.page.sheetRequested(wordSheet)
            onClosed: if (dialogs.back) dialogs.page.sheetRequested(dialogs.back)
        }
    }
    Component {
        id: idSheet
        TextSheet {
            title: dialogs.idLabel
            text: dialogs.filter.id
            onEdited: text => dialogs.draft = text
            onAccepted: {
                dialogs.filter.id = dialogs.draft
                dialogs.open()
            }
            onClosed: dialogs.open()
        }
    }
    Component {
        id: wordSheet
        TextSheet {
            title: qsTr("Word")
            text: dialogs.filter.word
            onEdited: text => dialogs.draft = text
            onAccepted: {
                dialogs.filter.word = dialogs.draft
                dialogs.open()
            }
            onClosed: dialogs.open()
        }
    }
}
