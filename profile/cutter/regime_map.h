// SPDX-License-Identifier: Apache-2.0
// The regime map: for each bag length the fastest rate with the ratios and the law of a program, and the
// limit that sets it. It asks the same limits as every check, so a new limit appears here without a change.
#pragma once

#include "profile/cutter/jaw.h"

#include <cstddef>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

struct RegimePoint {
    double bagLengthMm = 0;
    double rateBagsPerMin = 0;        // the fastest on the grid of the rate; 0: none
    Limit limit = Limit::MachineRate; // sets the rate, or excludes every rate
};

struct LengthRange {
    double fromMm = 0;
    double toMm = 0;
};

struct RegimeMap {
    std::vector<RegimePoint> points; // in the order of length
    std::vector<Limit> limits;       // that set a rate, in the order of the lengths
    CutterLengths lengths;
    LengthRange range;
    double maxRateBagsPerMin = 0; // of all points
};

// Returns the point of one bag length. The program must be valid; its inputs of the cycle are not used.
[[nodiscard]] RegimePoint regimePoint(const RotaryCutterProgram& program, const Machine& machine,
                                      double bagLengthMm);

// Returns the lengths that show all regimes and the program's own bag, in mm.
[[nodiscard]] LengthRange regimeRange(const RotaryCutterProgram& program, const Machine& machine);

// Returns the map with `count` (at least 2) even lengths, and beside them the exact ends of the feasible
// lengths. Refuses invalid ratios, law and machine data, without suggestions.
[[nodiscard]] tl::expected<RegimeMap, Refusal> regimeMap(const RotaryCutterProgram& program,
                                                         const Machine& machine, const LengthRange& range,
                                                         std::size_t count);

} // namespace campanel::profile
