// SPDX-License-Identifier: Apache-2.0
// The base of whatever opens above a page: sheets, keypads, the login. What was typed in it is `pending` until it is confirmed; the
// frame closes nothing that is pending.
pragma ComponentBehavior: Bound
import QtQuick

FocusScope {
    id: overlay

    property bool beside                   // at the left of the page, the rest of which stays within reach
    property real besideRight              // its right end then; 0: it covers the page
    property real free                     // right end of what a keypad leaves visible; 0: all
    property real closeLeft: width         // left end of the key that closes it
    property bool pending                  // closing would lose something
    property bool ready                    // a touch elsewhere may confirm it: a valid number
    property bool secret                   // does not outlive the logout of its user
    property bool warned                   // somebody has tried to leave it while it was pending
    readonly property string warning: warned ? qsTr("Not confirmed yet. Confirm or cancel first.") : ""
    signal taken()                         // to be confirmed without closing
    signal closed()

    onPendingChanged: if (!pending) warned = false

    // Forgets what is secret.
    function forget(): void {}
    // Confirms a valid number. Returns false when something stays pending.
    function settle(): bool {
        if (overlay.pending && overlay.ready)
            overlay.taken()
        overlay.warned = overlay.pending
        return !overlay.pending
    }
}
