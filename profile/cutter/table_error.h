// SPDX-License-Identifier: Apache-2.0
// The errors of a table against the smooth curve that it was built from.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <cstdint>
#include <span>

namespace campanel::profile {

// One slice of a table, or the part of it that one row holds: the constant speed of `pulses` in `ticks`.
struct TableSlice {
    std::int64_t startTick = 0;
    std::int64_t ticks = 0;
    std::int64_t pulses = 0;
    bool endsSlice = true; // false for a part that is not the last of its slice
};

// The errors of a cycle that begins with an empty remainder. Positions are those of constant speed within a
// slice; single pulses add a granularity of up to one pulse. The figures are upper bounds; the position is
// exact to 1e-9 mm, the mean square to 1e-6.
struct TableErrors {
    double speedMmPerS = 0;  // maximum |slice speed - curve|
    double speedPercent = 0; // the same in percent of the cycle's maximum speed
    double speedTimeS = 0;
    double frequencyStepHz = 0; // maximum step between neighboring slices, including the wrap
    double frequencyStepTimeS = 0;
    double boundaryPulses = 0; // maximum position error at slice boundaries
    double boundaryTimeS = 0;
    double insidePulses = 0; // maximum position error anywhere
    double insideTimeS = 0;
    double rmsPulses = 0; // root mean square of the position error over time
};

[[nodiscard]] TableErrors tableErrors(const RotaryCutter& cutter, std::span<const TableSlice> slices);

} // namespace campanel::profile
