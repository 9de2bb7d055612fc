// SPDX-License-Identifier: Apache-2.0
// Below parameters of the controller: the result of the last write, and a key to save them.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Panel

Item {
    id: foot

    required property ParameterFields fields
    required property string name          // the objects begin with it

    height: Theme.size.touch

    Label {
        objectName: foot.name + "Text"
        anchors { left: parent.left; right: save.left; rightMargin: Theme.size.padding; top: parent.top; bottom: parent.bottom }
        wrapMode: Text.WordWrap
        fontSizeMode: Text.Fit
        verticalAlignment: Text.AlignVCenter
        text: foot.fields.outcomeText.length > 0 ? foot.fields.outcomeText
            : qsTr("Changes take effect at once. Press Save to keep the values after power-off.")
        color: foot.fields.failed ? Theme.color.fault : foot.fields.outcomeText.length > 0 ? Theme.color.ink : Theme.color.secondaryInk
    }
    Button {
        id: save
        objectName: foot.name + "Save"
        level: Access.Technician
        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
        glyph: Theme.icon.save
        text: qsTr("Save")
        enabled: foot.fields.unsaved
        onClicked: foot.fields.save()
    }
}
