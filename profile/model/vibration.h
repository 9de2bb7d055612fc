// SPDX-License-Identifier: Apache-2.0
// The vibration of a shaft behind its motor: one mode with natural frequency and damping, driven by the
// motor's motion. x'' + 2 z w x' + w^2 x = w^2 u, with u the motor's position and x that of the knife or
// load.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"

namespace campanel::profile {

struct ShaftMode {
    double naturalFrequencyHz = 0; // 0: unknown
    double dampingRatio = 0;       // of critical damping, in (0, 1)

    [[nodiscard]] bool isKnown() const { return naturalFrequencyHz > 0; }
};

[[nodiscard]] ShaftMode shaftMode(const Machine& machine);

// Returns the peak-to-peak error x - u in mm between two times of a motion that repeats for ever: the sum of
// V_k (H(k) - 1) / (i k W1) e^(i k W1 t) over the harmonics of its speed, with H = w^2 / (w^2 - W^2 + 2 i z w
// W). NaN while the mode is unknown. The result is exact but for the shape of the law between some hundred
// points.
[[nodiscard]] double windowErrorMm(const MotionProfile& motion, double fromS, double toS,
                                   const ShaftMode& mode);

// Returns the same over the whole cycle: of a cam, whose load has to follow everywhere. A step of the speed,
// as at the wrap of a natural spline, strikes the mode.
[[nodiscard]] double cycleErrorMm(const MotionProfile& motion, const ShaftMode& mode);

// Returns the amplitude in mm that remains after a motion from one steady speed to another, rest to rest
// among them: |A(w)| / w, A = integral of a e^(-i w t). Damping is left out; it makes the amplitude smaller.
// NaN while the mode is unknown.
[[nodiscard]] double residualAmplitudeMm(const MotionProfile& motion, const ShaftMode& mode);

} // namespace campanel::profile
