// SPDX-License-Identifier: Apache-2.0
// A new PIN: entered twice, refused when it is easy to guess.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Parts
import CamPanel.Panel

DigitPanel {
    id: sheet

    required property int level            // level of the user; Service needs more digits
    readonly property int minDigits: Access.minPinDigits(sheet.level)
    property string first                  // first entry
    property bool holds                    // the name of a user who is not stored before the PIN, typed by somebody
    property int neededLevel               // of the person who confirms the PIN, who may have been logged out meanwhile; 0: everybody
    property string refusal
    signal entered(string pin)             // and closed()

    function forget(): void {
        sheet.first = ""
        pad.clear()
    }
    function take(pin: string): void {
        if (!Access.ask(sheet.neededLevel))
            return
        const isSecond = sheet.first.length > 0
        sheet.refusal = isSecond ? (pin === sheet.first ? "" : qsTr("The two PINs differ. Enter the new PIN again.")) : Access.pinRefusal(pin, sheet.level)
        sheet.first = isSecond || sheet.refusal.length > 0 ? "" : pin
        if (isSecond && sheet.refusal.length === 0) {
            sheet.entered(pin)
            sheet.closed()
        }
    }

    pending: sheet.holds || sheet.first.length > 0 || pad.digits.length > 0
    sentence: qsTr("%1 to 8 digits. A forgotten PIN cannot be read; a user of the level Service can set a new PIN.").arg(sheet.minDigits)
    pad {
        level: sheet.neededLevel
        fewest: sheet.minDigits
        label: sheet.first.length > 0 ? qsTr("Repeat PIN") : qsTr("New PIN")
        hint: sheet.refusal.length > 0 ? sheet.refusal : sheet.first.length > 0 ? qsTr("Enter the same PIN again.") : qsTr("Enter the new PIN.")
        hintIsFault: sheet.refusal.length > 0
        onAccepted: pin => sheet.take(pin)
        onEdited: sheet.refusal = ""
    }
}
