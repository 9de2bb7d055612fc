// SPDX-License-Identifier: Apache-2.0
// The value scale of a panel: round numbers at its ends and 3 to 4 ticks. It stays where it is while the data
// moves a little, so that a curve dragged by a finger moves and not its axis.
#pragma once

#include <qwt_scale_div.h>

namespace campanel::plot {

class AxisScale {
public:
    // Makes minimum..maximum (finite, minimum <= maximum) visible; true if the scale had to change for it. A
    // scale that is up to 1/keepFraction times wider than a new one would be is kept. minimumSpan: data
    // flatter than this counts as constant.
    bool fit(double minimum, double maximum, double minimumSpan);

    // Forgets the past: the next fit() starts afresh.
    void reset() { m_division = QwtScaleDiv(); }

    [[nodiscard]] double lower() const { return m_division.lowerBound(); }
    [[nodiscard]] double upper() const { return m_division.upperBound(); }
    // Distance of two ticks.
    [[nodiscard]] double step() const;
    [[nodiscard]] const QwtScaleDiv& division() const { return m_division; }

    static constexpr double keepFraction = 0.6;

private:
    QwtScaleDiv m_division;
};

// Digits after the decimal mark that tell ticks apart which are `step` from each other.
[[nodiscard]] int decimalsOfStep(double step);

} // namespace campanel::plot
