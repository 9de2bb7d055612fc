// SPDX-License-Identifier: Apache-2.0
// The frame around the pages, for whatever stands in it: it opens a sheet, another page or a section of it, or the keypad.
pragma Singleton
pragma ComponentBehavior: Bound
import QtQuick

QtObject {
    property bool covered                  // a sheet, a keypad or the login is above the page

    // Opens a sheet by its file in qml/, as "Download/ProofSheet". `values` are its properties and the functions that
    // answer its signals: { title: qsTr("Parity"), onChosen: key => ... }. They belong to a page or a section; a sheet,
    // which does not outlive the next one, gives no functions.
    signal open(string sheet, var values)
    signal close()
    signal openPage(string name)
    // Opens a section of a page by its file: ("settings", "StopsSection.qml").
    signal openSection(string page, string section)
    // Opens the keypad for fields[index], a list of Value; `source` stays in sight, null: nothing has to. The heading takes the place of
    // the label unless it is empty.
    signal edit(var fields, int index, Item source, string heading)
}
