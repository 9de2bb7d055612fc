// SPDX-License-Identifier: Apache-2.0
// 7" panels of 1024x600.
pragma ComponentBehavior: Bound
import QtQuick

SizeClass {
    name: "medium"
    screen: Qt.size(1024, 600)
    diagonalInch: 7
    topBar: 56
    navigation: 93
    wideGap: 12
    padding: 12
    radius: 8
    sideColumn: 290
    fieldColumns: 2
    caption: 14
    body: 16
    title: 20
    value: 30
    hero: 54
    command: 24
    icon: 28
    largeIcon: 52
    handle: 28
    mark: 13
    curve: 3
}
