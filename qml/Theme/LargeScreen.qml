// SPDX-License-Identifier: Apache-2.0
// 10.1" panels of 1280x800 and windows of at least that size.
pragma ComponentBehavior: Bound
import QtQuick

SizeClass {
    name: "large"
    screen: Qt.size(1280, 800)
    diagonalInch: 10.1
    topBar: 68
    navigation: 108
    wideGap: 14
    padding: 16
    radius: 10
    sideColumn: 352
    fieldColumns: 1
    caption: 16
    body: 18
    title: 23
    value: 36
    hero: 68
    command: 28
    icon: 32
    largeIcon: 60
    handle: 30
    mark: 15
    curve: 3
}
