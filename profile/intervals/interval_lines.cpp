// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/interval_lines.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile::detail {

namespace {

constexpr double speedRoundingShare = 1e-9; // share of the maximum speed

// Returns the area below the lines, in pulses.
double distance(const std::vector<PathPoint>& knots)
{
    double sum = 0;
    for (std::size_t i = 1; i < knots.size(); ++i)
        sum += (knots[i].speedHz + knots[i - 1].speedHz) / 2 * (knots[i].timeS - knots[i - 1].timeS);
    return sum;
}

// Sets lines that are horizontal except for rounding exactly horizontal.
void level(std::vector<PathPoint>& knots, double roundingHz)
{
    for (std::size_t i = knots.size() - 1; i-- > 0;) {
        if (std::abs(knots[i].speedHz - knots[i + 1].speedHz) <= roundingHz)
            knots[i].speedHz = knots[i + 1].speedHz;
    }
}

// Raises the inner knots by the missing pulses; the ends belong to the curve. A horizontal last line stays
// horizontal.
std::vector<PathPoint> raised(std::vector<PathPoint> knots, double missingPulses, double minHz)
{
    std::size_t last = knots.size() - 1;
    if (knots[last - 1].speedHz == knots[last].speedHz)
        --last;
    if (last < 2)
        return knots;
    const double firstS = knots[1].timeS - knots.front().timeS;
    const double lastS = knots[last].timeS - knots[last - 1].timeS;
    const double widthS = knots[last].timeS - knots.front().timeS - (firstS + lastS) / 2;
    for (std::size_t i = 1; i < last; ++i)
        knots[i].speedHz = maxOf(minHz, knots[i].speedHz + missingPulses / widthS);
    return knots;
}

// Returns the middles of the sections inside the motion that are faster, or slower, than their surroundings.
std::vector<SpeedPeak> peaksOf(const SpeedCurve& curve)
{
    constexpr std::size_t plateauSamples = 4;
    const std::vector<CurveSample>& samples = curve.samples();
    const double roundingHz = speedRoundingShare * curve.fastestHz();
    std::vector<SpeedPeak> result;
    double slope = 0;      // sign of the last change
    std::size_t level = 0; // first sample after it
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double change = samples[i].speedHz - samples[i - 1].speedHz;
        if (std::abs(change) <= roundingHz)
            continue;
        const double sign = change > 0 ? 1 : -1;
        if (slope * sign < 0)
            result.push_back({(level + i - 1) / 2, i - level >= plateauSamples ? 0 : slope});
        slope = sign;
        level = i;
    }
    return result;
}

} // namespace

IntervalLines::IntervalLines(const SpeedCurve& curve, double minHz, double maxHz)
    : m_curve(curve)
    , m_minHz(minHz)
    , m_maxHz(maxHz)
    , m_peaks(peaksOf(curve))
    , m_channel(curve.samples().size())
{
    const std::vector<CurveSample>& samples = curve.samples();
    for (std::size_t i = 2; i < samples.size(); ++i) {
        const double firstS = samples[i - 1].timeS - samples[i - 2].timeS;
        const double lastS = samples[i].timeS - samples[i - 1].timeS;
        if (firstS <= 0 || lastS <= 0)
            continue;
        const double turn = (samples[i].speedHz - samples[i - 1].speedHz) / lastS -
                            (samples[i - 1].speedHz - samples[i - 2].speedHz) / firstS;
        m_bendIntegral += std::sqrt(std::abs(turn) * minOf(firstS, lastS));
    }
}

std::size_t IntervalLines::fewest(double errorHz, std::size_t maxLines)
{
    const std::vector<CurveSample>& samples = m_curve.samples();
    const double stretch = m_curve.stretch();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double speed = samples[i].speedHz / stretch;
        const double width = errorHz + samples[i].bulgeHz;
        m_channel[i] = {samples[i].timeS, maxOf(0.0, speed - width), minOf(m_maxHz, speed + width)};
    }
    fixEnds();
    const auto knots = minLinks(m_channel, maxLines);
    return knots ? knots->size() - 1 : 0;
}

std::size_t IntervalLines::flatCount(Flats flats) const
{
    if (flats == Flats::None)
        return 0;
    return m_peaks.size() + (flats == Flats::PeaksAndEnd ? 1 : 0);
}

void IntervalLines::lay(double errorHz, const LineStyle& style, double shiftHz)
{
    const std::vector<CurveSample>& samples = m_curve.samples();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        // The mean error of a line over a parabola between its ends is a third of its largest error, towards
        // the inside of the bend.
        const double middle = samples[i].speedHz + shiftHz - style.evenness * samples[i].bend * errorHz / 3;
        m_channel[i] = {samples[i].timeS, maxOf(middle - errorHz, m_minHz), minOf(middle + errorHz, m_maxHz)};
    }
    fixEnds();
    if (style.flats == Flats::None)
        return;
    for (const SpeedPeak& peak : m_peaks)
        pinch(peak, errorHz);
    if (style.flats == Flats::PeaksAndEnd) {
        const std::size_t last = samples.size() - 1;
        m_channel[last].lowerHz = m_channel[last].upperHz;
        m_channel[last - 1].lowerHz = m_channel[last - 1].upperHz = m_channel[last].upperHz;
    }
}

// Makes the only way through two gates horizontal, at a peak where it is longest.
void IntervalLines::pinch(const SpeedPeak& peak, double errorHz)
{
    const Gate& gate = m_channel[peak.sample];
    const double middle = (gate.lowerHz + gate.upperHz) / 2;
    const double level = clamped(middle - peak.sign * errorHz, gate.lowerHz, gate.upperHz);
    for (const std::size_t i : {peak.sample, peak.sample + 1})
        m_channel[i].lowerHz = m_channel[i].upperHz = level;
}

// Fixes the ends of a motion that begins or ends moving to its own speed, not stretched to whole pulses.
void IntervalLines::fixEnds()
{
    const std::vector<CurveSample>& samples = m_curve.samples();
    if (!m_curve.beginsAtRest())
        m_channel.front().lowerHz = m_channel.front().upperHz = samples.front().speedHz / m_curve.stretch();
    if (!m_curve.endsAtRest())
        m_channel.back().lowerHz = m_channel.back().upperHz = samples.back().speedHz / m_curve.stretch();
}

std::optional<std::vector<PathPoint>> IntervalLines::within(double errorHz, std::size_t lineCount,
                                                            const LineStyle& style, double shiftHz)
{
    lay(errorHz, style, shiftHz);
    return minLinks(m_channel, lineCount);
}

bool IntervalLines::canKeep(double errorHz, std::size_t lineCount, double evenness)
{
    constexpr double margin = 1 + 1e-6;
    return within(errorHz * margin, lineCount, {Flats::None, evenness}, 0).has_value();
}

// Returns nearly the smallest error, by bisection on a logarithmic scale around a guess.
std::optional<IntervalLines::Tried> IntervalLines::tightest(std::size_t lineCount, const LineStyle& style,
                                                            double shiftHz, double guessHz)
{
    constexpr double precision = 1.015;
    constexpr double firstStep = 1.2;
    const double minHz = 1e-7 * m_curve.fastestHz();
    double high = guessHz;
    double step = firstStep;
    auto best = within(high, lineCount, style, shiftHz);
    double low = high;
    if (best) {
        while (high > minHz) {
            low = high / step;
            auto better = within(low, lineCount, style, shiftHz);
            if (!better)
                break;
            best = std::move(better);
            high = low;
            step *= step;
        }
    } else {
        while (!best) {
            low = high;
            high *= step;
            step *= step;
            if (low > 2 * m_curve.fastestHz())
                return std::nullopt;
            best = within(high, lineCount, style, shiftHz);
        }
    }
    while (high > minHz && high > precision * low) {
        const double middle = std::sqrt(high * low);
        if (auto better = within(middle, lineCount, style, shiftHz)) {
            best = std::move(better);
            high = middle;
        } else {
            low = middle;
        }
    }
    level(*best, speedRoundingShare * m_curve.fastestHz());
    const double missing = m_curve.samples().back().pulses - distance(*best);
    return Tried{std::move(*best), high, missing / m_curve.durationS()};
}

std::optional<Lines> IntervalLines::find(std::size_t lineCount, const LineStyle& style)
{
    constexpr int attempts = 6;
    constexpr double closeEnough = 0.02; // share of the error by which lines may be raised
    constexpr double linesPerBend = 4;   // lines of the smallest error over a constant jerk: j h^2 / 16
    const double perLine = m_bendIntegral / (linesPerBend * static_cast<double>(lineCount));
    double guess = maxOf(perLine * perLine, 1e-6 * m_curve.fastestHz());
    double shift = 0;
    std::optional<Lines> result;
    for (int i = 0; i < attempts; ++i) {
        auto tried = tightest(lineCount, style, shift, guess);
        if (!tried)
            break;
        const double missingHz = std::abs(tried->missingHz);
        const double errorHz = (tried->errorHz + std::abs(shift)) * (1 + style.evenness / 3) + missingHz;
        const bool isClose = missingHz <= closeEnough * tried->errorHz;
        shift += tried->missingHz;
        guess = tried->errorHz;
        if (!result || errorHz < result->errorHz) {
            const double missingPulses = tried->missingHz * m_curve.durationS();
            result = Lines{raised(std::move(tried->knots), missingPulses, m_minHz), errorHz};
        }
        if (isClose)
            break;
    }
    return result;
}

} // namespace campanel::profile::detail
