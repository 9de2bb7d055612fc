// SPDX-License-Identifier: Apache-2.0
// The approved windows of the chosen recipe: the lowest and highest value of each input. A value outside needs a reason before
// it reaches the controller. The draft was begun before.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    readonly property RecipeWindows windows: Recipes.windows

    title: qsTr("Approved values of %1").arg(Recipes.chosenName)
    note: windows.problem.length > 0 ? windows.problem : qsTr("A value outside needs a reason. The limits of the machine stay.")
    pending: windows.touched

    ListView {
        id: list
        objectName: "windowRows"
        anchors.fill: parent
        clip: true
        spacing: Theme.size.spacing
        boundsBehavior: Flickable.StopAtBounds
        model: sheet.windows.rows
        delegate: ListRow {
            id: row
            required property RecipeWindow modelData
            readonly property real tileWidth: Math.round(0.25 * width)
            tappable: false
            text: modelData.label
            note: modelData.present
            rightPadding: tiles.width
            Row {
                id: tiles
                anchors.right: parent.right
                spacing: Theme.size.spacing
                Field {
                    id: lowest
                    objectName: "windowLowest_" + row.modelData.fieldId
                    width: row.tileWidth
                    height: row.height
                    level: Access.Technician
                    label: qsTr("Lowest")
                    Accessible.name: row.modelData.lowest.label
                    value: row.modelData.lowest.text
                    unit: row.modelData.lowest.unit
                    onClicked: Frame.edit([row.modelData.lowest, row.modelData.highest], 0, lowest, "")
                }
                Field {
                    id: highest
                    objectName: "windowHighest_" + row.modelData.fieldId
                    width: row.tileWidth
                    height: row.height
                    level: Access.Technician
                    label: qsTr("Highest")
                    Accessible.name: row.modelData.highest.label
                    value: row.modelData.highest.text
                    unit: row.modelData.highest.unit
                    onClicked: Frame.edit([row.modelData.lowest, row.modelData.highest], 1, highest, "")
                }
                Button {
                    objectName: "windowClear_" + row.modelData.fieldId
                    Accessible.name: Theme.fill(qsTr("No window for %1"), [row.modelData.label])
                    width: Theme.size.touch
                    height: row.height
                    enabled: row.modelData.isSet
                    glyph: Theme.icon.close
                    onClicked: row.modelData.clear()
                }
            }
        }
    }
    ScrollMark { view: list }
    footer: [
        Button {
            objectName: "windowsCancel"
            text: qsTr("Cancel")
            onClicked: sheet.closed()
        },
        Button {
            objectName: "windowsSave"
            level: Access.Technician
            kind: Button.Primary
            enabled: sheet.windows.touched && sheet.windows.problem.length === 0
            text: qsTr("Save")
            onClicked: {
                if (!Access.ask(Access.Technician))
                    return
                sheet.windows.store()
                sheet.closed()
            }
        }
    ]
}
