// SPDX-License-Identifier: Apache-2.0
// Dark colors: a dim hall, a night shift.
pragma ComponentBehavior: Bound
ColorScheme {
    dark: true
    textContrast: 4.5
    largeTextContrast: 3
    ground: "#11161B"
    surface: "#1A2128"
    inset: "#222B33"
    ink: "#E8EEF3"
    secondaryInk: "#93A1AE"
    line: "#2E3943"
    touch: "#4DB3E6"
    touchTint: "#16374A"
    touchInk: "#0B1A23"
    touchPressed: "#86CDF0"
    good: "#4CC38A"
    warning: "#F0B03F"
    fault: "#F26D6D"
    stop: "#46535E"
    stopPressed: "#66747F"
    stopEdge: "#8593A0"
    stopInk: "#FFFFFF"
    target: "#5E6F7E"
    sync: "#38627D"
    disabledInk: "#8593A0"
    scrim: "#A0060A0D"
    acceleration: "#A9BBCB"
    frequency: "#7FA9C9"
    position: "#8CC3E8"
    jerk: "#93A1AE"
}
