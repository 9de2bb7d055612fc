// SPDX-License-Identifier: Apache-2.0
// The list of a cam beside its curve: keys for the previous and the next entry, all entries at the left, the numbers of the
// selected one at the right, tools below.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property CamHandles handles
    required property string remark        // on the whole cam
    property alias list: list
    default property alias numbers: column.data
    property alias tools: tools.data

    // Returns the width of a tool of which a row has so many; the last one takes what is left.
    function toolWidth(count: int, last: bool): real {
        const width = Math.floor((tools.width - (count - 1) * tools.spacing) / count)
        return last ? tools.width - (count - 1) * (width + tools.spacing) : width
    }

    title: Theme.fill(qsTr("%1 of %2"), [handles.selected + 1, handles.count])
    beside: true
    // Three keys beside the title, also with gloves.
    panelWidth: Math.max(besideWidth, 3 * Theme.size.touch + 2 * Theme.size.padding + 5 * Theme.size.body)
    panelHeight: height

    header: [
        Button {
            objectName: "previousEntry"
            Accessible.name: qsTr("Previous")
            kind: Button.Quiet
            glyph: Theme.icon.previous
            enabled: sheet.handles.selected > 0
            onClicked: --sheet.handles.selected
        },
        Button {
            objectName: "nextEntry"
            Accessible.name: qsTr("Next")
            kind: Button.Quiet
            glyph: Theme.icon.next
            enabled: sheet.handles.selected < sheet.handles.count - 1
            onClicked: ++sheet.handles.selected
        }
    ]
    content: [
        ListView {
            id: list
            anchors { left: parent.left; top: parent.top; bottom: tools.top; bottomMargin: Theme.size.spacing }
            width: Math.round(parent.width * 0.42)
            clip: true
            spacing: Theme.size.outline
            boundsBehavior: Flickable.StopAtBounds
            currentIndex: sheet.handles.selected
            onCurrentIndexChanged: positionViewAtIndex(currentIndex, ListView.Contain)
            highlightFollowsCurrentItem: false
        },
        ScrollMark { view: list; x: list.width - width },
        Flickable {
            id: flick
            objectName: "entryNumbers"
            anchors { left: list.right; leftMargin: Theme.size.spacing; right: parent.right; top: parent.top; bottom: list.bottom }
            contentHeight: remark.y + remark.height
            clip: true
            boundsBehavior: Flickable.StopAtBounds
            Column {
                id: column
                width: flick.width - scrollMark.room
                spacing: Theme.size.spacing
            }
            Label {
                id: remark
                anchors { top: column.bottom; topMargin: Theme.size.spacing; left: parent?.left; right: parent?.right; rightMargin: 2 * Theme.size.accent }
                wrapMode: Text.WordWrap
                text: sheet.remark
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        },
        ScrollMark { id: scrollMark; view: flick },
        Flow {
            id: tools
            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            spacing: Theme.size.spacing
        }
    ]
}
