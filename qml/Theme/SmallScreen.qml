// SPDX-License-Identifier: Apache-2.0
// 7" panels of 800x480.
pragma ComponentBehavior: Bound
import QtQuick

SizeClass {
    name: "small"
    screen: Qt.size(800, 480)
    diagonalInch: 7
    topBar: 44
    navigation: 82
    wideGap: 8
    padding: 8
    radius: 6
    sideColumn: 232
    fieldColumns: 2
    caption: 13
    body: 14
    title: 17
    value: 24
    hero: 42
    command: 20
    icon: 22
    largeIcon: 40
    handle: 24
    mark: 11
    curve: 2
}
