// SPDX-License-Identifier: Apache-2.0
// A motion as few intervals of constant acceleration that keep its speed within an error: the table of the
// paper on intervals (rows Dist, V0, V1, Acc for two cascaded accumulators).
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
    Published, // registers in pulses/s and pulses/s^2: the generator's clock makes it all 1.00663296 times
               // slower
    Corrected, // speeds times k = 2^23 / (50 MHz / 6) = 1.00663296, acceleration times k^2, with fraction
               // bits
};

struct IntervalTable {
    std::vector<IntervalRow> rows; // each begins with the speed that the one before it ends with
    // No fewer straight lines keep the speed error, whatever their distance and time. A row goes along up to
    // two of them, a ramp and a stretch at its last speed.
    int fewestLinks = 0;
    int fractionBits = 0;
    std::int64_t advance = 0;     // sum of the rows' pulses, negative: backwards
    std::uint32_t cycleTicks = 0; // of the timer, in which the last pulse comes
    double timeS = 0;             // from the start to the last pulse, by the generator's clock
    double profileTimeS = 0;      // of the motion
    IntervalErrors errors;
};

// Returns the fewest rows that interval_plan.h finds; a larger error never takes more. Where the motion
// begins or ends moving the rows have exactly its speed, at rest a small one above zero. Distances sum to the
// motion's pulses rounded to whole ones. Each row reaches its last speed within its distance. Refuses a speed
// error that is not positive, that whole pulses cannot keep or that would take more rows than the controller
// holds (SpeedError; allowed is one that is kept, infinite when there is none), a motion that turns round
// (Reversal), less than one pulse (TooFewPulses), pulses faster than the output stage (PulseFrequency) and
// numbers that do not fit their registers (TableRange).
[[nodiscard]] tl::expected<IntervalTable, Refusal> compileIntervals(const MotionProfile& motion,
                                                                    const Machine& machine,
                                                                    double speedErrorMmPerS,
                                                                    IntervalMode mode);

} // namespace campanel::profile
