// SPDX-License-Identifier: Apache-2.0
// The filter of a list of records: limits of time, moved by keys, a day, an id and a word. Each key takes effect at once.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property LogFilter filter
    required property string idLabel
    property int limit: LogFilter.From     // the limit that the keys move
    signal idRequested()
    signal wordRequested()

    title: qsTr("Filter")

    component LimitRow: ChoiceRow {
        required property int which
        property string value
        width: limits.width
        note: value.length > 0 ? value : qsTr("no limit")
        holds: sheet.limit === which
        onClicked: sheet.limit = which
    }
    component Step: Button {
        required property int minutes
        width: (keys.width - 3 * Theme.size.spacing) / 4
        onClicked: sheet.filter.move(sheet.limit, minutes)
    }
    component Half: Button {
        width: (keys.width - Theme.size.spacing) / 2
    }

    Column {
        id: limits
        anchors { left: parent.left; top: parent.top }
        width: Math.round(parent.width * 0.42)
        spacing: Theme.size.spacing
        LimitRow {
            objectName: "filterFrom"
            which: LogFilter.From
            text: qsTr("From")
            value: sheet.filter.fromText
        }
        LimitRow {
            objectName: "filterTo"
            which: LogFilter.To
            text: qsTr("To")
            value: sheet.filter.toText
        }
        SettingRow {
            objectName: "filterId"
            width: limits.width
            label: sheet.idLabel
            value: sheet.filter.id.length > 0 ? sheet.filter.id : qsTr("any")
            onClicked: sheet.idRequested()
        }
        SettingRow {
            objectName: "filterWord"
            width: limits.width
            label: qsTr("Word")
            value: sheet.filter.word.length > 0 ? sheet.filter.word : qsTr("any")
            onClicked: sheet.wordRequested()
        }
    }
    Column {
        id: keys
        anchors { left: limits.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top }
        spacing: Theme.size.spacing
        Row {
            spacing: Theme.size.spacing
            Step {
                objectName: "filterEarlierWeek"
                minutes: -10080
                text: qsTr("− 7 d")
            }
            Step {
                objectName: "filterEarlierDay"
                minutes: -1440
                text: qsTr("− 1 d")
            }
            Step {
                objectName: "filterLaterDay"
                minutes: 1440
                text: qsTr("+ 1 d")
            }
            Step {
                objectName: "filterLaterWeek"
                minutes: 10080
                text: qsTr("+ 7 d")
            }
        }
        Row {
            spacing: Theme.size.spacing
            Step {
                objectName: "filterEarlierHour"
                minutes: -60
                text: qsTr("− 1 h")
            }
            Step {
                objectName: "filterEarlier"
                minutes: -10
                text: qsTr("− 10 min")
            }
            Step {
                objectName: "filterLater"
                minutes: 10
                text: qsTr("+ 10 min")
            }
            Step {
                objectName: "filterLaterHour"
                minutes: 60
                text: qsTr("+ 1 h")
            }
        }
        Row {
            spacing: Theme.size.spacing
            Half {
                objectName: "filterDay"
                text: qsTr("This day only")
                onClicked: sheet.filter.showDay(sheet.limit)
            }
            Half {
                objectName: "filterNoLimit"
                text: qsTr("No limit")
                enabled: sheet.limit === LogFilter.From ? sheet.filter.fromText.length > 0 : sheet.filter.toText.length > 0
                onClicked: sheet.filter.removeLimit(sheet.limit)
            }
        }
        Row {
            spacing: Theme.size.spacing
            Half {
                objectName: "filterSheetClear"
                text: qsTr("Clear filter")
                enabled: sheet.filter.active
                onClicked: sheet.filter.clear()
            }
            Half {
                objectName: "filterShow"
                kind: Button.Primary
                text: qsTr("Show")
                onClicked: sheet.closed()
            }
        }
    }
}
