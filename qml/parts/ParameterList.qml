// SPDX-License-Identifier: Apache-2.0
// Parameters of the controller that a technician sets, as a list.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: parameters

    required property ParameterFields fields
    required property string name          // the objects of the rows begin with it
    signal measureRequested(int row)
    property Item heading: null             // stands above the first row and moves with the rows
    readonly property real headingHeight: parameters.heading ? parameters.heading.height + Theme.size.spacing : 0

    ListView {
        id: list
        objectName: parameters.name + "List"
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top; bottomMargin: Theme.size.spacing }
        clip: true
        spacing: Theme.size.outline
        boundsBehavior: Flickable.StopAtBounds
        model: parameters.fields
        topMargin: parameters.headingHeight
        onTopMarginChanged: contentY = -topMargin
        delegate: ParameterRow {
            objectName: parameters.name + index
            neededLevel: Access.Technician
            onClicked: {
                if (toggle)
                    return
                parameters.fields.select(index)
                Frame.edit([parameters.fields.value], 0, null, "")
            }
            onChosen: choice => parameters.fields.setChoice(index, choice)
            onMeasureRequested: parameters.measureRequested(index)
            onSuggestionTaken: parameters.fields.takeSuggestion(index)
        }
    }
    Binding {
        target: parameters.heading
        property: "parent"
        value: list.contentItem
    }
    ScrollMark { view: list }
    ParameterFoot {
        id: foot
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        fields: parameters.fields
        name: parameters.name
    }
}
