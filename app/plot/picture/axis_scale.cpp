// SPDX-License-Identifier: Apache-2.0
#include "app/plot/picture/axis_scale.h"

#include <qwt_scale_engine.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::plot {

namespace {

constexpr int maxSteps = 3;
// The share of the scale by which data may exceed the last tick (rounding).
constexpr double overshoot = 1e-6;

QwtScaleDiv roundScale(double minimum, double maximum)
{
    const QwtLinearScaleEngine engine;
    double step = 0;
    engine.autoScale(maxSteps, minimum, maximum, step);
    QwtScaleDiv division = engine.divideScale(minimum, maximum, maxSteps, 0, step);
    QList<double> ticks = division.ticks(QwtScaleDiv::MajorTick);
    // Alignment to round numbers can give four steps; every second tick is then sufficient. Zero keeps its
    // tick.
    if (ticks.size() == 5 && (ticks[1] == 0 || ticks[3] == 0)) {
        const double wide = ticks[2] - ticks[0];
        const double low = ticks[1] == 0 ? -wide : -2 * wide;
        return QwtScaleDiv(low, low + 3 * wide, {}, {}, {low, low + wide, low + 2 * wide, low + 3 * wide});
    }
    if (ticks.size() == 5) {
        division.setTicks(QwtScaleDiv::MajorTick, {ticks[0], ticks[2], ticks[4]});
    }
    return division;
}

} // namespace

bool AxisScale::fit(double minimum, double maximum, double minimumSpan)
{
    if (maximum - minimum < minimumSpan) {
        // A flat curve is in the middle of a scale that starts at a round number below it.
        const double middle = (minimum + maximum) / 2;
        const double half = std::max(minimumSpan, std::abs(middle) / 2);
        minimum = middle - half;
        maximum = middle + half;
    }
    const double slack = overshoot * (maximum - minimum);
    const QwtScaleDiv fresh =
        scaled(roundScale((minimum + slack) * m_factor, (maximum - slack) * m_factor), 1 / m_factor);
    const bool visible = !m_division.isEmpty() && minimum + slack >= lower() && maximum - slack <= upper();
    if (visible && fresh.range() >= keepFraction * m_division.range()) {
        return false;
    }
    const bool changed = !(fresh == m_division);
    m_division = fresh;
    return changed;
}

void AxisScale::setFactor(double factor)
{
    if (std::exchange(m_factor, factor) != factor)
        reset();
}

int AxisScale::decimals() const
{
    return decimalsOfStep(step() * m_factor);
}

QwtScaleDiv scaled(const QwtScaleDiv& division, double factor)
{
    QwtScaleDiv made(division.lowerBound() * factor, division.upperBound() * factor);
    QList<double> ticks = division.ticks(QwtScaleDiv::MajorTick);
    for (double& tick : ticks)
        tick *= factor;
    made.setTicks(QwtScaleDiv::MajorTick, ticks);
    return made;
}

double AxisScale::step() const
{
    const QList<double> ticks = m_division.ticks(QwtScaleDiv::MajorTick);
    return ticks.size() < 2 ? 0.0 : ticks[1] - ticks[0];
}

int decimalsOfStep(double step)
{
    if (!(step > 0)) {
        return 0;
    }
    // 1e-9 keeps a step of 0.1 from counting as slightly less.
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

} // namespace campanel::plot
