// SPDX-License-Identifier: Apache-2.0
// The pages without a key of their own in the navigation.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Parts

ListPicker {
    id: sheet

    required property var pages            // list of {page, text, glyph}

    title: qsTr("More pages")
    choices: sheet.pages.map(each => ({ key: each.page, text: each.text, glyph: each.glyph }))
    onChosen: page => Frame.openPage(page)
}
