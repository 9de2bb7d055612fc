// SPDX-License-Identifier: Apache-2.0
// A text of an alarm below its caption; takes no space without a text.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls

Column {
    id: block

    required property string name          // name for tests
    required property string caption
    required property string text
    property bool large                    // readable at arm's length

    width: parent.width
    visible: text.length > 0
    Label {
        text: block.caption
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Label {
        objectName: block.name
        width: Math.min(implicitWidth, block.parent.width)
        wrapMode: Text.Wrap
        text: block.text
        font.pixelSize: block.large ? Theme.size.title : Theme.size.body
    }
}
