// SPDX-License-Identifier: Apache-2.0
// A derived number explained: formula, formula with numbers, result.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Sheet {
    id: sheet

    required property EditorField field

    title: field.label
    panelWidth: width * 0.75
    panelHeight: height * 0.8

    Readout {
        id: number
        anchors { left: parent.left; right: parent.right; top: parent.top }
        text: sheet.field.text
        unit: sheet.field.unit
    }
    Label {
        anchors { left: parent.left; right: parent.right; top: number.bottom; topMargin: Theme.size.padding; bottom: parent.bottom }
        verticalAlignment: Text.AlignTop
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        text: sheet.field.derived ? sheet.field.explanation
            : sheet.field.explanation + (sheet.field.explanation.length > 0 ? "\n" : "") + Theme.fill(qsTr("This value is entered, not calculated. The range is %1 to %2."), [Theme.number(sheet.field.minimum, sheet.field.decimals), Theme.number(sheet.field.maximum, sheet.field.decimals)])
        lineHeight: 1.2
    }
    footer: Button {
        level: sheet.field.neededLevel
        visible: sheet.field.pinnable && sheet.field.derived
        kind: Button.Primary
        glyph: Theme.icon.pin
        text: qsTr("Enter this value instead")
        onClicked: {
            sheet.field.togglePin()
            sheet.closed()
        }
    }
}
