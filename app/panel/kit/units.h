// SPDX-License-Identifier: Apache-2.0
// The units that a person reads and types: millimeters, or inches by the setting display.units. The only
// place that knows them. Whatever is stored, sent or written to a file is in the metric unit, as its name
// says.
#pragma once

#include <QString>
#include <QVariantMap>

#include <array>

namespace campanel::panel {

// A metric unit as it is shown; the same unit where the setting is metric, or where there is no other.
struct ShownUnit {
    QString unit;
    double factor = 1; // shown value / metric value
    const std::array<int, 4>* inchDecimals = nullptr;

    [[nodiscard]] bool isConverted() const { return inchDecimals != nullptr; }
    // Returns the decimals for a value with so many in the metric unit.
    [[nodiscard]] int decimals(int metric) const;
};

class Units {
public:
    // Sets the units of all texts, as QLocale::setDefault() sets their language. Texts follow as after a
    // change of the language.
    static void setInch(bool isInch);
    [[nodiscard]] static bool isInch();

    // Texts are for the screen from now on: no line break between a number and its unit. campanelctl writes
    // plain spaces.
    static void setOnScreen();
    [[nodiscard]] static bool isOnScreen();

    // `unit` is the metric one as it is shown: "mm", "mm/s²".
    [[nodiscard]] static ShownUnit of(const QString& unit);
    // Returns the metric value of a number that was typed. A number that reads like `present` is that one, to
    // the last bit; one that reads like a round metric number is that number: 7.0866 in is 180.0 mm.
    [[nodiscard]] static double typed(double shown, const QString& unit, int metricDecimals, double present);

    // Returns the converted units for QML by their metric name, {unit, factor, decimals} each.
    [[nodiscard]] static QVariantMap rows(bool isInch);
};

} // namespace campanel::panel
