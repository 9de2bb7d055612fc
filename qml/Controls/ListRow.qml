// SPDX-License-Identifier: Apache-2.0
// The base of the rows of all lists: a sign or a picture (`leftPadding` is free for it), the title above its small note; at
// the right a value above its own small note, what the row adds (`rightPadding` is free for it), and a mark: a chevron where
// a tap opens something. A row that is only read has no frame.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TouchButton {
    id: row

    property string glyph                  // the sign at the left
    property string note
    property string rightText
    property string rightNote
    property string mark: row.tappable ? Theme.icon.next : ""
    property bool holds                    // selected
    property bool tappable: true
    property int frame: row.tappable ? Theme.size.hairline : 0
    property color frameColor: row.holds ? Theme.color.touch : Theme.color.line
    property real rightRoom: rightText.length > 0 ? rightLabel.width + Theme.size.spacing : 0   // in the first line
    property alias sign: sign
    property alias titleLabel: titleLabel
    property alias noteLabel: noteLabel
    property alias rightLabel: rightLabel
    property alias rightNoteLabel: rightNoteLabel
    property alias arrow: arrow
    property alias words: words
    property alias firstLine: firstLine

    detail: row.rightText
    implicitWidth: ListView.view ? ListView.view.width - (ListView.view.visibleArea.heightRatio < 1 ? 2 * Theme.size.accent : 0) : Theme.size.touch
    implicitHeight: Math.max(Theme.size.touch, words.height + 2 * Theme.size.accent)
    down: tappable && pressed
    focusPolicy: tappable ? Qt.TabFocus : Qt.NoFocus
    Accessible.role: tappable ? Accessible.Button : Accessible.StaticText

    background: Rectangle {
        visible: row.frame > 0
        radius: Theme.size.radius
        color: row.holds || row.down ? Theme.color.touchTint : Theme.color.inset
        border { width: row.frame; color: row.frameColor }
    }
    IconLabel {
        id: sign
        anchors { left: parent.left; leftMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
        visible: row.glyph.length > 0
        code: row.glyph
        color: row.holds ? Theme.color.touch : Theme.color.secondaryInk
    }
    Column {
        id: words
        anchors {
            left: parent.left; leftMargin: Theme.size.padding + row.leftPadding + (sign.visible ? sign.width + Theme.size.padding : 0)
            right: parent.right; rightMargin: Theme.size.padding + row.rightPadding + (arrow.visible ? arrow.width : 0)
            verticalCenter: parent.verticalCenter
        }
        spacing: Theme.size.outline
        Item {
            id: firstLine
            width: parent.width
            height: Math.max(titleLabel.height, rightLabel.height)
            Label {
                id: titleLabel
                width: parent.width - row.rightRoom
                fontSizeMode: Text.HorizontalFit
                minimumPixelSize: Theme.size.caption   // no smaller than its note
                wrapMode: Text.Wrap
                maximumLineCount: row.note.length > 0 ? 2 : 4
                text: row.text
                color: !row.enabled ? Theme.color.disabledInk : row.locked ? Theme.color.secondaryInk : Theme.color.ink
                font.weight: Font.DemiBold
            }
            Label {
                id: rightLabel
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                width: Math.min(implicitWidth, Math.max(parent.width * 0.6, parent.width - titleLabel.implicitWidth - Theme.size.spacing))
                horizontalAlignment: Text.AlignRight
                fontSizeMode: Text.HorizontalFit
                text: row.rightText
                color: titleLabel.color
            }
        }
        Item {
            visible: row.note.length + row.rightNote.length > 0
            width: parent.width
            height: Math.max(noteLabel.height, rightNoteLabel.height)
            Label {
                id: noteLabel
                width: parent.width - (row.rightNote.length > 0 ? rightNoteLabel.width + Theme.size.spacing : 0)
                fontSizeMode: Text.HorizontalFit
                text: row.note
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
            Label {
                id: rightNoteLabel
                anchors.right: parent.right
                width: Math.min(implicitWidth, parent.width * 0.6)
                horizontalAlignment: Text.AlignRight
                fontSizeMode: Text.HorizontalFit
                text: row.rightNote
                color: Theme.color.secondaryInk
                font.pixelSize: Theme.size.caption
            }
        }
    }
    IconLabel {
        id: arrow
        anchors { right: parent.right; rightMargin: Theme.size.spacing; verticalCenter: parent.verticalCenter }
        visible: row.mark.length > 0
        code: row.mark
        color: row.locked ? Theme.color.secondaryInk : row.enabled ? Theme.color.touch : Theme.color.disabledInk
    }
}
