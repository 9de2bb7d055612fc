// SPDX-License-Identifier: Apache-2.0
// A typed reason for values outside their approved windows.
pragma ComponentBehavior: Bound
import CamPanel.Parts
import CamPanel.Panel

TextSheet {
    title: qsTr("Why outside the approved window?")
    level: Access.Operator
    check: text => Editor.programDownload.windowReason.problem(text)
}
