// SPDX-License-Identifier: Apache-2.0
// One parameter of the controller by its name in the register table; read while it is visible, a tap opens the keypad.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Panel

SettingRow {
    id: tile

    required property string name
    readonly property ParameterField field: Controller.parameterField(name)

    label: field.label
    level: field.neededLevel
    value: field.shown
    onClicked: Frame.edit([tile.field], 0, null, "")
    onVisibleChanged: if (visible) field.read()
    Component.onCompleted: if (visible) field.read()

    Connections {
        target: Controller
        enabled: tile.visible
        function onConnectionChanged() { tile.field.read() }
    }
}
