// SPDX-License-Identifier: Apache-2.0
// Cuts slices. The pulses of a slice are differences of the rounded travel, so that no error accumulates. A
// slice ends at the tick where the curve passes that whole pulse (at most half a pulse from the equal
// division), so that its constant speed is the curve's.
#include "profile/cutter/table_slices.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace campanel::profile::detail {
namespace {

// One section of the table before rounding.
struct Stretch {
    double startS = 0;
    double endS = 0;
    bool isConstant = false;
};

std::vector<Stretch> stretches(const RotaryCutter& cutter)
{
    const auto segments = cutter.motion.segments();
    std::vector<Stretch> found;
    found.reserve(2 * static_cast<std::size_t>(cutter.program.slicesPerRamp) + segments.size());
    double start = 0;
    for (const Segment& segment : segments) {
        const int parts = segment.law == nullptr ? 1 : cutter.program.slicesPerRamp;
        for (int part = 1; part <= parts; ++part) {
            const double end = segment.startS + segment.durationS * part / parts;
            found.push_back({start, end, segment.law == nullptr});
            start = end;
        }
    }
    return found;
}

// Returns the section for the carried pulse: the longest of constant speed with enough space, else the
// longest with space.
std::size_t carryStretch(const RotaryCutter& cutter, const std::vector<Stretch>& all)
{
    constexpr double neededRoomPulses = 2; // the carried one and a rounding
    const auto score = [&](const Stretch& stretch) {
        const double lengthS = stretch.endS - stretch.startS;
        const double speed = cutter.motion.at((stretch.startS + stretch.endS) / 2).velocityMmPerS;
        const double spareHz = pulseFrequencyLimitHz(cutter.machine) - speed * pulsesPerMm(cutter.machine);
        const int rank =
            (spareHz * lengthS >= neededRoomPulses ? 2 : 0) + (stretch.isConstant && speed > 0 ? 1 : 0);
        return std::pair{rank, lengthS};
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (score(all[i]) > score(all[best]))
            best = i;
    }
    return best;
}

} // namespace

// N_i = round(F(t_i)) - round(F(t_i-1)); the cycle's fraction of a pulse is omitted after the carry section.
std::optional<SlicedCycle> cutSlices(const RotaryCutter& cutter, std::int64_t cycleTicks)
{
    const std::vector<Stretch> all = stretches(cutter);
    const std::size_t carry = carryStretch(cutter, all);
    const PulsesPerCycle cyclePulses = pulsesPerCycle(cutter.machine);
    const double fraction =
        static_cast<double>(cyclePulses.remainder) / static_cast<double>(cyclePulses.divisor);
    const double perMm = cyclePulses.asDouble() / cutter.cycle.strokeMm;
    const double clock = cutter.machine.timerClockHz;
    const std::int64_t constant = minTimerConstant(cutter.machine);

    std::vector<std::int64_t> pulses(all.size());
    std::vector<std::int64_t> endTicks(all.size());
    std::int64_t before = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool isLast = i + 1 == all.size();
        const double leftOut = i >= carry ? fraction : 0;
        const double travel = cutter.motion.at(all[i].endS).positionMm * perMm - leftOut;
        const std::int64_t after =
            isLast ? cyclePulses.whole
                   : clamped(std::int64_t{std::llround(travel)}, before, cyclePulses.whole);
        const double position = (static_cast<double>(after) + leftOut) / perMm;
        const std::int64_t exact =
            isLast ? cycleTicks : std::llround(cutter.motion.timeAt(position, all[i].endS) * clock);
        // A curve within the timer's frequency already has this distance between pulses; only noise could
        // reduce it by a tick.
        const std::int64_t earliest = (i > 0 ? endTicks[i - 1] : 0) + (after - before) * constant;
        endTicks[i] = maxOf(exact, earliest);
        pulses[i] = after - before;
        before = after;
    }
    if (endTicks.back() != cycleTicks)
        return std::nullopt;

    SlicedCycle cycle;
    cycle.slices.reserve(all.size());
    cycle.carrySlice = all.size();
    std::int64_t start = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (endTicks[i] == start)
            continue; // slower than a pulse per slice: its pulse is in a neighbor
        if (i == carry)
            cycle.carrySlice = cycle.slices.size();
        cycle.slices.push_back({start, endTicks[i] - start, pulses[i]});
        start = endTicks[i];
    }
    return cycle;
}

} // namespace campanel::profile::detail
