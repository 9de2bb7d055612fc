// SPDX-License-Identifier: Apache-2.0
// One pass over the motion for the positions, one spline for the slopes, then rounding and range checks.
#include "profile/cam/cam_table.h"

#include "profile/cam/spline.h"
#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"
#include "profile/model/limit_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace campanel::profile {
namespace {

// The tolerance for equal speeds and accelerations at both ends of a cycle, as a share of the mean ones.
constexpr double wrapTolerance = 1e-7;
constexpr double advancePerMm = 1e6; // grid of the net advance
constexpr double mm1000PerMm = 1000; // grid of the feed

// Evaluates the motion at ascending times.
class Walker {
public:
    explicit Walker(const MotionProfile& motion)
        : m_segments(motion.segments())
        , m_endS(motion.durationS())
    {
    }

    [[nodiscard]] MotionPoint at(double timeS)
    {
        const double time = minOf(timeS, m_endS);
        while (m_index + 1 < m_segments.size() && time >= m_segments[m_index + 1].startS)
            ++m_index;
        return m_segments[m_index].at(time);
    }

private:
    std::span<const Segment> m_segments;
    double m_endS;
    std::size_t m_index = 0;
};

Refusal tooLarge(Field field, double actual, double allowed)
{
    Refusal refusal;
    refusal.limit = Limit::TableRange;
    refusal.field = field;
    refusal.actual = actual;
    refusal.allowed = allowed;
    return refusal;
}

// Returns the units of a row per mm: 1/256 pulse.
double unitsPerMm(const Machine& machine)
{
    return camUnitsPerPulse * axisPulsesPerMm(machine);
}

tl::expected<PulsesPerCycle, Refusal> exactAdvance(double advanceMm, const Machine& machine)
{
    // The limit of the rows, so that the products below fit 64 bits.
    constexpr double maxPulses = std::numeric_limits<std::int32_t>::max() / camUnitsPerPulse;
    if (std::abs(advanceMm * axisPulsesPerMm(machine)) > maxPulses)
        return tl::unexpected(tooLarge(Field::PulsesPerMotorRev, std::abs(advanceMm) * unitsPerMm(machine),
                                       std::numeric_limits<std::int32_t>::max()));
    const std::int64_t micro = std::llround(advanceMm * advancePerMm);
    std::int64_t divisor = std::llround(machine.feedMmPerMotorRev * mm1000PerMm) *
                           static_cast<std::int64_t>(advancePerMm / mm1000PerMm);
    const std::int64_t common = std::gcd(micro, divisor);
    const std::int64_t numerator = micro / common * machine.pulsesPerMotorRev;
    divisor /= common;
    const std::int64_t shared = std::gcd(std::int64_t{machine.pulsesPerMotorRev}, divisor);
    divisor /= shared;
    if (divisor > std::numeric_limits<std::uint32_t>::max())
        return tl::unexpected(tooLarge(Field::FeedPerMotorRev, static_cast<double>(divisor),
                                       std::numeric_limits<std::uint32_t>::max()));
    const std::int64_t pulses = numerator / shared;
    const std::int64_t remainder = (pulses % divisor + divisor) % divisor;
    return PulsesPerCycle{(pulses - remainder) / divisor, remainder, divisor};
}

bool continuesAtWrap(const MotionPoint& first, const MotionPoint& last, double durationS, double scaleMm)
{
    return std::abs(first.velocityMmPerS - last.velocityMmPerS) * durationS <= wrapTolerance * scaleMm &&
           std::abs(first.accelerationMmPerS2 - last.accelerationMmPerS2) * durationS * durationS <=
               wrapTolerance * scaleMm;
}

// The positions in 1/256 pulse from the first one, unrounded, and the slopes per interval.
struct Samples {
    std::vector<double> positions;
    std::vector<double> slopes;
};

Samples sample(const MotionProfile& motion, std::size_t intervals, const Machine& machine, CamUse use)
{
    const double units = unitsPerMm(machine);
    const double intervalS = motion.durationS() / static_cast<double>(intervals);
    Samples samples;
    samples.positions.resize(intervals + 1);
    Walker walker(motion);
    const MotionPoint first = walker.at(0);
    Extent extent;
    for (std::size_t i = 0; i <= intervals; ++i) {
        const double position =
            units * (walker.at(intervalS * static_cast<double>(i)).positionMm - first.positionMm);
        samples.positions[i] = position;
        extent.add(position);
    }
    const Segment& end = motion.segments().back();
    const MotionPoint last = end.at(end.endS());
    const bool isPeriodic =
        use == CamUse::Repeats && continuesAtWrap(first, last, motion.durationS(), extent.span() / units);
    samples.slopes =
        unitSplineSlopes(samples.positions, isPeriodic ? SplineEnds::Periodic : SplineEnds::Clamped,
                         {units * first.velocityMmPerS * intervalS, units * last.velocityMmPerS * intervalS});
    return samples;
}

// Rounds half away from zero, like std::round, but without a library call. |value| must fit.
std::int32_t rounded(double value)
{
    return static_cast<std::int32_t>(value + std::copysign(0.5, value));
}

std::optional<Refusal> findTooFast(const CamTable& table, double durationS, const Machine& machine)
{
    const double intervalS = durationS / static_cast<double>(table.rows.size() - 1);
    std::int64_t maxStep = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
        const std::int64_t step =
            std::abs(std::int64_t{table.rows[i + 1].position256} - table.rows[i].position256);
        if (step <= maxStep)
            continue;
        maxStep = step;
        worst = i;
    }
    // Both positions are rounded by up to half a unit.
    const double needed = static_cast<double>(maxStep - 1) / camUnitsPerPulse / intervalS;
    const double allowed = pulseFrequencyLimitHz(machine);
    if (needed <= allowed * (1 + detail::limitTolerance))
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::MasterTooFast;
    refusal.field = Field::MaxPulseFrequency;
    refusal.actual = needed;
    refusal.allowed = allowed;
    refusal.unit = "Hz";
    refusal.timeS = (static_cast<double>(worst) + 0.5) * intervalS;
    return refusal;
}

tl::expected<CamTable, Refusal> tableOf(const MotionProfile& motion, double advanceMm, int intervals,
                                        const Machine& machine, CamUse use)
{
    if (!inRange(Field::CamPoints, intervals))
        return tl::unexpected(detail::outOfRange(Field::CamPoints, intervals));
    const double ticks = std::round(motion.durationS() * machine.timerClockHz);
    if (!(ticks <= std::numeric_limits<std::uint32_t>::max()))
        return tl::unexpected(tooLarge(Field::TimerClock, ticks, std::numeric_limits<std::uint32_t>::max()));
    const auto advance = exactAdvance(advanceMm, machine);
    if (!advance)
        return tl::unexpected(advance.error());
    const Samples samples = sample(motion, static_cast<std::size_t>(intervals), machine, use);
    CamTable table;
    table.cycleTicks = static_cast<std::uint32_t>(ticks);
    table.advance = *advance;
    table.rows.resize(samples.positions.size());
    constexpr double maxRaw = std::numeric_limits<std::int32_t>::max();
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double larger = maxOf(std::abs(samples.positions[i]), std::abs(samples.slopes[i]));
        if (!(larger <= maxRaw))
            return tl::unexpected(tooLarge(Field::PulsesPerMotorRev, larger, maxRaw));
        table.rows[i] = {rounded(samples.positions[i]), rounded(samples.slopes[i])};
    }
    if (auto refusal = findTooFast(table, motion.durationS(), machine))
        return tl::unexpected(*std::move(refusal));
    return table;
}

} // namespace

tl::expected<CamTable, Refusal> buildCamTable(const MotionProfile& motion, int intervals,
                                              const Machine& machine, CamUse use)
{
    const Segment& end = motion.segments().back();
    return tableOf(motion, end.at(end.endS()).positionMm - motion.at(0).positionMm, intervals, machine, use);
}

tl::expected<CamTable, Refusal> buildCamTable(const MotionProfile& forward, const CamMaster& master,
                                              double netAdvanceMm, const Machine& machine)
{
    const auto build = [&](int points) {
        return tableOf(forward, netAdvanceMm * master.slaveScale, points, machine, CamUse::Repeats);
    };
    auto table = build(master.camPoints);
    if (table)
        return table;
    Refusal& refusal = table.error();
    if (refusal.limit == Limit::MasterTooFast) {
        const double slower = master.masterRateRevPerMin * refusal.allowed / refusal.actual;
        const double step = info(Field::MasterRate).resolution();
        const double rate = std::copysign(std::floor(std::abs(slower) / step) * step, slower);
        if (rate != 0)
            refusal.nearest.push_back({Field::MasterRate, snapToGrid(Field::MasterRate, rate)});
    } else if (refusal.limit == Limit::FieldRange) {
        if (build(static_cast<int>(refusal.allowed)))
            refusal.nearest.push_back({Field::CamPoints, refusal.allowed});
    }
    return table;
}

CamPoint interpolate(const CamTable& table, std::size_t index, double share)
{
    const CamRow& a = table.rows[index];
    const CamRow& b = table.rows[index + 1];
    const double step = static_cast<double>(b.position256) - a.position256;
    const double second = 3 * step - 2.0 * a.slope256 - b.slope256;
    const double third = static_cast<double>(a.slope256) + b.slope256 - 2 * step;
    return {a.position256 + share * (a.slope256 + share * (second + share * third)),
            a.slope256 + share * (2 * second + share * 3 * third)};
}

} // namespace campanel::profile
