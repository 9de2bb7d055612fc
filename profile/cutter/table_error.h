// SPDX-License-Identifier: Apache-2.0
// How far a table departs from the smooth curve it was made from.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <cstdint>
#include <span>

namespace campanel::profile {

// One slice of a table before it is broken into rows: the even speed of `pulses` in `ticks`.
struct TableSlice {
    std::int64_t startTick = 0;
    std::int64_t ticks = 0;
    std::int64_t pulses = 0;
};

// Of a cycle that begins with an empty remainder. Positions are of the even motion within a slice; the single
// pulses add up to one pulse of granularity. No error is larger than stated here; the position's is exact to
// 1e-9 mm, the mean square to 1e-6.
struct TableErrors {
    double speedMmPerS = 0;  // largest |slice speed - curve|
    double speedPercent = 0; // the same in percent of the cycle's largest speed
    double speedTimeS = 0;
    double frequencyStepHz = 0; // largest step between neighboring slices, the wrap included
    double frequencyStepTimeS = 0;
    double boundaryPulses = 0; // largest position error at slice boundaries
    double boundaryTimeS = 0;
    double insidePulses = 0; // largest position error anywhere
    double insideTimeS = 0;
    double rmsPulses = 0; // of the position error over time
};

[[nodiscard]] TableErrors tableErrors(const RotaryCutter& cutter, std::span<const TableSlice> slices);

} // namespace campanel::profile
