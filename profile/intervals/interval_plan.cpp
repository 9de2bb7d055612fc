// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/interval_plan.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace campanel::profile::detail {

namespace {

constexpr double noLimit = std::numeric_limits<double>::infinity();
constexpr std::size_t coarsestSamples = 1024;
constexpr std::size_t samplesPerLine = 32;
constexpr std::array styles{LineStyle{Flats::None, 0}, LineStyle{Flats::Peaks, 0},
                            LineStyle{Flats::PeaksAndEnd, 0}};
// The styles with more error for the same rows, the smoothest first.
constexpr std::array smoothStyles{LineStyle{Flats::None, 1}, LineStyle{Flats::None, 0.5}};

constexpr std::size_t maxFineCount = 64; // every number of rows is tried up to this one

// Returns the styles that are tried. For large numbers, a row saved by level lines is insignificant.
std::span<const LineStyle> stylesOf(std::size_t count)
{
    return std::span(styles).first(count <= maxFineCount ? styles.size() : 1);
}

// Larger numbers grow in steps of a thirty-second part.
std::vector<std::size_t> rowCounts(std::size_t max)
{
    constexpr std::size_t stepsPerDouble = 32;
    std::vector<std::size_t> result;
    for (std::size_t count = 1; count <= max; count += count < maxFineCount ? 1 : count / stepsPerDouble)
        result.push_back(count);
    return result;
}

// Returns an error that no rows exceed.
double maxErrorHz(const SpeedCurve& curve)
{
    return 4 * curve.fastestHz();
}

// Returns the largest error of a linear speed change over the first pulse.
double firstPulseErrorHz(const SpeedCurve& curve, double firstHz, double lastHz)
{
    constexpr int checks = 10;
    const double endS = 2 / (firstHz + lastHz);
    double error = 0;
    for (int i = 0; i <= checks; ++i) {
        const double share = static_cast<double>(i) / checks;
        const double speedHz = firstHz + (lastHz - firstHz) * share;
        error = maxOf(error, std::abs(speedHz - curve.speedAt(endS * share)));
    }
    return error;
}

// Returns the smallest possible error of the first pulse when the motion begins at rest: a lower bound for
// all rows. Both speeds are searched around the best ones found so far, with decreasing steps.
double firstPulseErrorHz(const SpeedCurve& curve)
{
    if (!curve.beginsAtRest())
        return 0;
    constexpr int passes = 10;
    constexpr int choices = 6; // in both directions
    constexpr double closer = 0.4;
    double firstHz = 0;
    double lastHz = 2 / curve.timeAt(1);
    double width = lastHz;
    double best = firstPulseErrorHz(curve, firstHz, lastHz);
    for (int pass = 0; pass < passes; ++pass, width *= closer) {
        const double middleFirstHz = firstHz;
        const double middleLastHz = lastHz;
        for (int i = -choices; i <= choices; ++i) {
            for (int j = -choices; j <= choices; ++j) {
                const double first = maxOf(0.0, middleFirstHz + width * i / choices);
                const double last = maxOf(0.0, middleLastHz + width * j / choices);
                const double error = first + last > 0 ? firstPulseErrorHz(curve, first, last) : best;
                if (error < best) {
                    best = error;
                    firstHz = first;
                    lastHz = last;
                }
            }
        }
    }
    return best;
}

} // namespace

IntervalPlanner::IntervalPlanner(const MotionProfile& motion, double pulsesPerMm, const RowRules& rules,
                                 std::size_t maxRows)
    : m_motion(motion)
    , m_pulsesPerMm(pulsesPerMm)
    , m_rules(rules)
    , m_unitHz(1 / std::ldexp(rules.iterationS, accumulatorBits + rules.fractionBits))
    , m_counts(rowCounts(maxRows))
{
}

IntervalPlanner::Level& IntervalPlanner::levelOf(std::size_t lineCount)
{
    std::size_t level = 0;
    while ((coarsestSamples << level) < samplesPerLine * lineCount)
        ++level;
    if (m_levels.size() <= level)
        m_levels.resize(level + 1);
    if (!m_levels[level])
        m_levels[level] = std::make_unique<Level>(m_motion, m_pulsesPerMm, m_rules,
                                                  static_cast<int>(coarsestSamples << level));
    return *m_levels[level];
}

std::size_t IntervalPlanner::minLines(double errorMmPerS)
{
    const double errorHz = errorMmPerS * m_pulsesPerMm + m_unitHz;
    const std::size_t max = 2 * m_counts.back();
    std::size_t lines = 1;
    while (true) {
        Level& level = levelOf(lines);
        lines = level.lines.fewest(errorHz, max);
        if (lines == 0 || &levelOf(lines) == &level)
            return lines;
    }
}

std::optional<IntervalPlan> IntervalPlanner::plan(std::size_t rowCount, const LineStyle& style,
                                                  double errorMmPerS)
{
    const PlanKey key{rowCount, style.flats, style.evenness};
    if (const auto made = m_errors.find(key); made != m_errors.end() && made->second > errorMmPerS)
        return std::nullopt;
    Level& level = levelOf(rowCount);
    const SpeedCurve& curve = level.curve;
    const std::size_t lineCount = rowCount + level.lines.flatCount(style.flats);
    // The searched curve is stretched to whole pulses.
    const double stretchHz = std::abs(1 - 1 / curve.stretch()) * curve.fastestHz();
    const double allowedHz = minOf(errorMmPerS * m_pulsesPerMm + stretchHz, maxErrorHz(curve));
    if (!level.lines.canKeep(allowedHz / (1 + style.evenness / 3), lineCount, style.evenness))
        return std::nullopt;
    const auto lines = level.lines.find(lineCount, style);
    if (!lines || lines->errorHz > allowedHz || rowsOf(lines->knots) > rowCount ||
        maxRowsOf(lines->knots) + 1 < rowCount)
        return std::nullopt;
    constexpr double firstFactor = 1.02;
    constexpr double fineFactor = 1.2;
    constexpr double coarseFactor = 1.5; // for whole pulses that need far more than the lines
    constexpr double far = 4;
    double failedHz = lines->errorHz;
    double factor = firstFactor;
    while (failedHz <= allowedHz) {
        const double toleranceHz = factor * failedHz + m_unitHz;
        if (auto rows = rowsAlong(lines->knots, curve, m_rules, toleranceHz)) {
            IntervalPlan result{std::move(*rows), {}, 0};
            result.errors = intervalErrors(result.rows, m_rules.fractionBits, m_rules.iterationS, m_motion,
                                           m_pulsesPerMm);
            result.errorMmPerS = maxOf(result.errors.speedMmPerS, failedHz / m_pulsesPerMm);
            // The smallest number that keeps the error has the fewest rows of all.
            m_errors[key] = result.rows.size() + 1 >= rowCount ? result.errorMmPerS : noLimit;
            return m_errors[key] <= errorMmPerS && m_errors[key] < noLimit ? std::optional(std::move(result))
                                                                           : std::nullopt;
        }
        failedHz = toleranceHz;
        factor = failedHz < far * lines->errorHz ? fineFactor : coarseFactor;
    }
    return std::nullopt;
}

// Returns the error of lines below which the rows do not improve: they have whole pulses and whole speeds.
double IntervalPlanner::finestHz()
{
    if (!m_finestHz) {
        constexpr double share = 0.7;
        constexpr double minShare = 1e-6; // share of the maximum speed
        const SpeedCurve& curve = levelOf(1).curve;
        m_finestHz = maxOf(share * maxOf(m_unitHz, firstPulseErrorHz(curve)), minShare * curve.fastestHz());
    }
    return *m_finestHz;
}

// Returns true when fewer lines are as fine as rows can be.
bool IntervalPlanner::isTooMany(std::size_t count)
{
    return count > 1 && levelOf(count).lines.fewest(finestHz(), count - 1) != 0;
}

// Returns true when too many lines are shorter than a pulse: the rows are those of a smaller number.
bool IntervalPlanner::isTooShort(std::size_t count)
{
    IntervalLines& lines = levelOf(count).lines;
    return std::ranges::all_of(stylesOf(count), [&](const LineStyle& style) {
        const auto found = lines.find(count + lines.flatCount(style.flats), style);
        return found && maxRowsOf(found->knots) + 1 < count;
    });
}

// Returns how many of the numbers of rows may have a plan. With more rows the lines only become shorter.
std::size_t IntervalPlanner::usefulCounts()
{
    constexpr std::size_t margin = 4; // the first too short one is found by bisection
    if (!m_usefulCounts) {
        std::size_t useful = 0;
        std::size_t end = m_counts.size();
        while (end - useful > 1) {
            const std::size_t middle = (useful + end) / 2;
            (isTooMany(m_counts[middle]) || isTooShort(m_counts[middle]) ? end : useful) = middle;
        }
        m_usefulCounts = minOf(end + margin, m_counts.size());
    }
    return *m_usefulCounts;
}

std::optional<IntervalPlan> IntervalPlanner::minRows(double errorMmPerS)
{
    constexpr int easyTries = 8; // before the end of the search is looked for
    const std::size_t lines = minLines(errorMmPerS);
    if (lines == 0)
        return std::nullopt;
    int tries = 0;
    for (std::size_t place = 0; place < m_counts.size(); ++place) {
        const std::size_t count = m_counts[place];
        if (count + levelOf(count).lines.flatCount(Flats::PeaksAndEnd) < lines)
            continue;
        if (isTooMany(count) || (++tries > easyTries && place >= usefulCounts()))
            break;
        std::optional<IntervalPlan> result;
        for (const LineStyle& style : stylesOf(count)) {
            auto found = plan(count, style, errorMmPerS);
            if (found && (!result || found->rows.size() < result->rows.size()))
                result = std::move(found);
        }
        if (!result)
            continue;
        for (const LineStyle& style : smoothStyles) {
            auto smoother = plan(count, style, errorMmPerS);
            if (smoother && smoother->rows.size() <= result->rows.size())
                return smoother;
        }
        return result;
    }
    return std::nullopt;
}

double IntervalPlanner::keptErrorMmPerS(double triedMmPerS)
{
    constexpr std::size_t stride = 24; // through large numbers of rows
    constexpr int tries = 5;
    const std::size_t lines = maxOf(minLines(triedMmPerS), maxFineCount);
    std::size_t i = usefulCounts() - 1;
    while (i > 0 && (isTooMany(m_counts[i]) || (lines > maxFineCount && m_counts[i] > lines)))
        --i;
    double best = noLimit;
    for (int tried = 0;; ++tried) {
        for (const LineStyle& style : stylesOf(m_counts[i])) {
            if (const auto found = plan(m_counts[i], style, best))
                best = found->errorMmPerS;
        }
        const bool isFine = m_counts[i] <= maxFineCount;
        if (i == 0 || (!isFine && tried >= tries && best != noLimit))
            return best;
        i -= isFine ? 1 : minOf(i, maxOf<std::size_t>(1, minOf(stride, i / 4)));
    }
}

} // namespace campanel::profile::detail
