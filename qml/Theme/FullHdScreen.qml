// SPDX-License-Identifier: Apache-2.0
// 15.6" panels of 1920x1080 and windows of almost that size: read from some steps away.
pragma ComponentBehavior: Bound
import QtQuick

SizeClass {
    name: "fullHd"
    screen: Qt.size(1920, 1080)
    diagonalInch: 15.6
    topBar: 88
    navigation: 140
    wideGap: 18
    padding: 20
    radius: 12
    sideColumn: 480
    fieldColumns: 1
    caption: 20
    body: 24
    title: 30
    value: 50
    hero: 98
    command: 34
    icon: 40
    largeIcon: 76
    handle: 36
    mark: 18
    curve: 4
}
