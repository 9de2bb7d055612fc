// SPDX-License-Identifier: Apache-2.0
// The machine data of the axes, typed by hand or measured by the controller.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

SettingsSection {
    id: section

    readonly property AxisMeasurement measurement: Maintenance.measurement
    readonly property bool empty: section.measurement.emptyText.length > 0

    title: qsTr("Axes")

    onVisibleChanged: if (section.visible) section.measurement.open()
    Component.onCompleted: section.measurement.open()
    Connections {
        target: Controller
        function onConnectionChanged(): void {
            if (section.visible)
                section.measurement.open()
        }
    }

    Label {
        objectName: "axesEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: section.empty
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: section.measurement.emptyText
        color: Theme.color.secondaryInk
    }
    ParameterList {
        anchors { fill: parent; topMargin: section.bodyTop }
        visible: !section.empty
        fields: section.measurement.fields
        name: "axes"
        onMeasureRequested: row => {
            section.measurement.begin(row)
            Frame.open("Settings/AxisSheet", {})
        }
    }
}
