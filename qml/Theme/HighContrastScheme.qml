// SPDX-License-Identifier: Apache-2.0
// High contrast: tired eyes, a dirty or sunlit screen. Black cards on nearly black; every text and curve at least 7:1.
pragma ComponentBehavior: Bound
ColorScheme {
    dark: true
    textContrast: 7
    largeTextContrast: 7
    ground: "#1C1C1C"
    surface: "#000000"
    inset: "#101010"
    ink: "#FFFFFF"
    secondaryInk: "#DADADA"
    line: "#8C8C8C"
    touch: "#6FD0FF"
    touchTint: "#00304A"
    touchInk: "#000000"
    touchPressed: "#C2ECFF"
    good: "#5CF09A"
    warning: "#FFC94D"
    fault: "#FF8A8A"
    stop: "#303030"
    stopPressed: "#000000"
    stopEdge: "#FFFFFF"
    stopInk: "#FFFFFF"
    target: "#B4B4B4"
    sync: "#3C8DBC"
    disabledInk: "#B4B4B4"
    scrim: "#C0000000"
    acceleration: "#D8E6F2"
    frequency: "#A9CBE6"
    position: "#B8DCFF"
    jerk: "#C4C4C4"
}
