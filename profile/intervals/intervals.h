// SPDX-License-Identifier: Apache-2.0
// Compiles a motion into few intervals of constant acceleration that keep its speed within an error. The
// result is the table of the paper on intervals (rows Dist, V0, V1, Acc for two cascaded accumulators).
#pragma once

#include "profile/intervals/interval_errors.h"
#include "profile/intervals/interval_row.h"
#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"

#include <cstdint>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

inline constexpr int intervalCapacity = 1024; // rows that the controller holds

enum class IntervalMode : std::uint8_t {
    Published, // registers in pulses/s and pulses/s^2: the generator's clock makes the motion 1.00663296
               // times slower
    Corrected, // speeds times k = 2^23 / (50 MHz / 6) = 1.00663296, acceleration times k^2, with fraction
               // bits
};

struct IntervalTable {
    std::vector<IntervalRow> rows; // each starts with the last speed of the previous row
    // The lower bound of the number of straight lines that keep the speed error, for any distance and
    // duration. A row covers up to two lines: a ramp and a stretch at its last speed.
    int minLinks = 0;
    int fractionBits = 0;
    std::int64_t advance = 0;     // sum of the rows' pulses; negative: backward
    std::uint32_t cycleTicks = 0; // timer ticks until the last pulse
    double timeS = 0;             // from the start to the last pulse, at the generator's clock
    double profileTimeS = 0;      // duration of the source motion
    IntervalErrors errors;
};

// Returns the fewest rows that interval_plan.h finds; a larger error never takes more rows. Where the motion
// begins or ends moving, the rows have exactly its speed; at rest, a small speed above zero. The distances
// sum to the motion's pulses, rounded to whole ones. Each row reaches its last speed within its distance.
// Refusals: SpeedError (the error is not positive, cannot be kept with whole pulses or takes more rows than
// the controller holds; `allowed` is an error that can be kept, infinite when there is none); Reversal (the
// motion reverses); TooFewPulses (less than one pulse); PulseFrequency (pulses faster than the output stage);
// TableRange (values that do not fit their registers).
[[nodiscard]] tl::expected<IntervalTable, Refusal> compileIntervals(const MotionProfile& motion,
                                                                    const Machine& machine,
                                                                    double speedErrorMmPerS,
                                                                    IntervalMode mode);

} // namespace campanel::profile
