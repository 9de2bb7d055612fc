// SPDX-License-Identifier: Apache-2.0
// Solves the two equations between bag length, rate, v_a and v_b for every pair of inputs. Internal to
// profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

namespace campanel::profile::detail {

// The figures that follow from the ratios, the law and the machine alone.
struct CycleShape {
    double strokeMm = 0; // h
    double weight = 0;   // w = W / T, in (0, 1)
    double syncRatio = 1;
    double shortestRamp = 0; // the shorter of the two ramps, as a fraction of T
    LawPeaks lawPeaks;
};

// The part of the shape that law and machine give.
struct LawAndStroke {
    double strokeMm = 0;  // h
    double lawTravel = 0; // G(1)
    LawPeaks lawPeaks;
};

// Compute the shape. The ratios and the law of the program must have been validated.
[[nodiscard]] CycleShape cycleShape(const RotaryCutterProgram& program, const Machine& machine);
[[nodiscard]] CycleShape cycleShape(const RotaryCutterProgram& program, const LawAndStroke& given);

// The four values; not finite or negative where no cycle exists.
struct CycleValues {
    double bagLengthMm = 0;
    double cycleTimeS = 0;
    double baseSpeedMmPerS = 0;
    double filmSpeedMmPerS = 0;

    [[nodiscard]] double of(Field field) const;
};

struct FieldValue {
    Field field = Field::BagLength;
    double value = 0;
};

// Solves the numbers of a program whose inputs are valid. Refuses what solveNumbers() refuses after
// validation.
[[nodiscard]] tl::expected<CycleNumbers, Refusal> solveValid(const RotaryCutterProgram& program,
                                                             const CycleShape& shape);

// Solves h = v_a (T - W) + v_b W and v_b = c L / T for two given, different values of L, n, v_a, v_b.
[[nodiscard]] CycleValues closeCycle(const CycleShape& shape, FieldValue first, FieldValue second);

} // namespace campanel::profile::detail
