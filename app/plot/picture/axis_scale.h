// SPDX-License-Identifier: Apache-2.0
// The value scale of a panel: round numbers at its ends and 3 to 4 ticks. It stays unchanged while the data
// moves a little, so that during a drag the curve moves and not its axis.
#pragma once

#include <qwt_scale_div.h>

namespace campanel::plot {

class AxisScale {
public:
    // Makes minimum..maximum (finite, minimum <= maximum) visible; returns true if the scale had to change.
    // Keeps a scale that is up to 1/keepFraction times wider than a new one. minimumSpan: data with a smaller
    // span counts as constant.
    bool fit(double minimum, double maximum, double minimumSpan);

    // The ticks are round numbers of the data times this factor: of the unit that is shown.
    void setFactor(double factor);
    [[nodiscard]] double factor() const { return m_factor; }
    // Returns the decimals of the ticks' numbers.
    [[nodiscard]] int decimals() const;

    // Resets the scale for the next fit().
    void reset() { m_division = QwtScaleDiv(); }

    [[nodiscard]] double lower() const { return m_division.lowerBound(); }
    [[nodiscard]] double upper() const { return m_division.upperBound(); }
    // Returns the distance between two ticks.
    [[nodiscard]] double step() const;
    [[nodiscard]] const QwtScaleDiv& division() const { return m_division; }

    static constexpr double keepFraction = 0.6;

private:
    QwtScaleDiv m_division;
    double m_factor = 1;
};

// Returns a division with the same ticks in another unit.
[[nodiscard]] QwtScaleDiv scaled(const QwtScaleDiv& division, double factor);

// Returns the decimals needed for ticks with this step.
[[nodiscard]] int decimalsOfStep(double step);

} // namespace campanel::plot
