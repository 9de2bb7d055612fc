// SPDX-License-Identifier: Apache-2.0
// Light colors: a bright hall.
pragma ComponentBehavior: Bound
ColorScheme {
    dark: false
    textContrast: 4.5
    largeTextContrast: 3
    ground: "#E7EBEE"
    surface: "#FFFFFF"
    inset: "#F3F5F7"
    ink: "#17212B"
    secondaryInk: "#5A6875"
    line: "#CFD6DC"
    touch: "#0A6C9E"
    touchTint: "#DCEEF7"
    touchInk: "#FFFFFF"
    touchPressed: "#08557D"
    good: "#1E7B4A"
    warning: "#8F5500"
    fault: "#B3261E"
    stop: "#2B3640"
    stopPressed: "#10171D"
    stopEdge: "#10171D"
    stopInk: "#FFFFFF"
    target: "#9AA8B4"
    sync: "#8BB0C9"
    disabledInk: "#6B7782"
    scrim: "#8017212B"
    acceleration: "#3F5566"
    frequency: "#5B7F98"
    position: "#2F5D80"
    jerk: "#6B7782"
}
