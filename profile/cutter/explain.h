// SPDX-License-Identifier: Apache-2.0
// Explains a derived number: the formula, the formula with numbers, the result. The text contains symbols
// only, so it needs no translation.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <string>
#include <string_view>

namespace campanel::profile {

enum class CutterQuantity : std::uint8_t {
    BagLength,
    Rate,
    BaseSpeed,
    FilmSpeed,
    Weight, // W
    PeakMotorRpm,
    PeakAcceleration,
    PeakFrequency,
    SyncWindow, // as an angle of the knife's shaft
    SealTime,
    RmsAcceleration,
    SpeedRatio,      // k0
    BaseCircleSpeed, // omega of the paper's cam
    PeakTorque, // torques and error are NaN while the machine data are unknown
    RmsTorque,
    SealError,
};

struct Explanation {
    std::string formula; // "v_a = (h - v_b W) / (T - W)"
    std::string numbers; // "(376.991 - 250 * 0.35) / (1 - 0.35)"
    double result = 0;
    std::string_view unit;
};

// Returns the explanation of a quantity. For a pinned quantity, formula and numbers are the value itself.
[[nodiscard]] Explanation explain(const RotaryCutter& cutter, CutterQuantity quantity);

} // namespace campanel::profile
