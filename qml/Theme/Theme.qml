// SPDX-License-Identifier: Apache-2.0
// The only source of colors, sizes, icons, durations and number format. The frame sets its inputs; the rest is data.
pragma ComponentBehavior: Bound
pragma Singleton
import QtQuick

QtObject {
    id: theme

    property string name: "light"
    property string language: "en"
    property size window: Qt.size(1024, 600)
    // Pixels per millimeter of a real screen; 0 while the panel's size is known only by its class.
    property real screenPixelsPerMm: 0
    property bool animated: true

    property bool gloves: false            // keys for a hand in a glove
    property var units: ({})               // by their metric names, those that are shown instead: {unit, factor, decimals}

    readonly property ColorScheme color: name === "dark" ? theme.dark : name === "contrast" ? theme.contrast : theme.light
    readonly property SizeClass size: theme.window.width >= 1800 && theme.window.height >= 1000 ? theme.fullHd
        : theme.window.width >= 1200 && theme.window.height >= 720 ? theme.large
        : theme.window.width >= 960 && theme.window.height >= 560 ? theme.medium : theme.small
    readonly property IconCodes icon: IconCodes {}
    readonly property string iconFamily: "Material Design Icons"
    readonly property var locale: Qt.locale(theme.language)
    readonly property font captionFont: Qt.font({ pixelSize: theme.size.caption })
    readonly property string unknownText: "--"

    readonly property int shortTime: theme.animated ? 120 : 0
    property int longPressTime: 600
    readonly property int holdTime: 500    // of a key that commands the machine, and until a held key repeats
    readonly property int repeatTime: 200  // of a held key
    readonly property int clockTime: 1000
    readonly property int lookAgainTime: 2000

    readonly property ColorScheme light: LightScheme {}
    readonly property ColorScheme dark: DarkScheme {}
    readonly property ColorScheme contrast: HighContrastScheme {}
    readonly property SizeClass small: SmallScreen {}
    readonly property SizeClass medium: MediumScreen {}
    readonly property SizeClass large: LargeScreen {}
    readonly property SizeClass fullHd: FullHdScreen {}

    readonly property Binding density: Binding {
        target: theme.size
        property: "pixelsPerMm"
        value: theme.screenPixelsPerMm
        when: theme.screenPixelsPerMm > 0
    }

    readonly property Binding reach: Binding {
        target: theme.size
        property: "reach"
        value: theme.gloves ? 1.25 : 1
    }

    // Formats a number in the panel's language, with a minus sign instead of a hyphen; an unknown value is "--", never 0.
    // Only counts have group separators.
    function number(value: real, decimals: int): string {
        return theme.count(value, decimals).split(theme.locale.groupSeparator).join("")
    }
    function count(value: real, decimals: int): string {
        if (isNaN(value))
            return theme.unknownText
        const shown = Math.abs(value) < Math.pow(10, -decimals) / 2 ? 0 : value    // a rounded -0 would read as "-0.0"
        return Number(shown).toLocaleString(theme.locale, 'f', decimals).replace(theme.locale.negativeSign, "\u2212")
    }
    function signedNumber(value: real, decimals: int): string {
        return (value > 0 ? "+" : "") + theme.number(value, decimals)
    }
    // A length, speed or acceleration is named by its metric unit, here and nowhere else converted.
    function shownUnit(unit: string): string { return theme.units[unit]?.unit ?? unit }
    function unitFactor(unit: string): real { return theme.units[unit]?.factor ?? 1 }
    function unitDecimals(decimals: int, unit: string): int { return theme.units[unit]?.decimals[Math.min(decimals, 3)] ?? decimals }
    function amount(value: real, decimals: int, unit: string): string {
        return theme.number(value * theme.unitFactor(unit), theme.unitDecimals(decimals, unit))
    }
    function signedAmount(value: real, decimals: int, unit: string): string { return (value > 0 ? "+" : "") + theme.amount(value, decimals, unit) }
    // Joins a number and its unit, which no line break divides. An unknown number has no unit.
    function joined(number: string, unit: string): string {
        return number === theme.unknownText || unit.length === 0 ? number : unit === "°" ? number + unit : number + "\u00a0" + unit.replace(/\//g, "/\u2060")
    }
    function measure(value: real, decimals: int, unit: string): string { return theme.joined(theme.amount(value, decimals, unit), theme.shownUnit(unit)) }
    function signedMeasure(value: real, decimals: int, unit: string): string { return theme.joined(theme.signedAmount(value, decimals, unit), theme.shownUnit(unit)) }
    // Returns a text with its places %1, %2 ... filled at once: a name may contain such a place itself.
    function fill(text: string, values: var): string {
        return text.replace(/%(\d)/g, (place, number) => values[number - 1])
    }
    // Returns a sentence without line breaks between a number and its unit, or within a unit at its slash.
    function unbroken(sentence: string): string {
        return sentence.replace(/(\d) (?=[%°µA-Za-z\u4e00-\u9fff])/g, "$1\u00a0").replace(/\//g, "/\u2060")
    }
}
