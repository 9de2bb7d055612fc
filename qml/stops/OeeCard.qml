// SPDX-License-Identifier: Apache-2.0
// Effectiveness and its three factors; a held finger explains each with its numbers.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Card {
    id: card

    component Figure: Item {
        id: figure
        required property string label
        required property real value
        required property int topic
        property bool large
        width: grid.width / 2
        height: grid.height / 2
        Readout {
            anchors { left: parent.left; right: parent.right; margins: Theme.size.padding; verticalCenter: parent.verticalCenter }
            title: figure.label
            text: Theme.number(100 * figure.value, 1)
            unit: "%"
            pixelSize: figure.large ? Math.round(1.3 * Theme.size.value) : Theme.size.value
        }
        Explained {
            quantities: [figure.topic]
        }
    }

    Grid {
        id: grid
        anchors.fill: parent
        columns: 2
        Figure {
            objectName: "figureOee"
            label: qsTr("OEE")
            value: Stops.shift.oee
            topic: Explanations.Oee
            large: true
        }
        Figure {
            objectName: "figureAvailability"
            label: qsTr("Availability")
            value: Stops.shift.availability
            topic: Explanations.Availability
        }
        Figure {
            objectName: "figurePerformance"
            label: qsTr("Performance")
            value: Stops.shift.performance
            topic: Explanations.Performance
        }
        Figure {
            objectName: "figureQuality"
            label: qsTr("Quality")
            value: Stops.shift.quality
            topic: Explanations.Quality
        }
    }
}
