// SPDX-License-Identifier: Apache-2.0
// The rotary cutter cam: base speed v_a, a ramp, film speed v_b while the knife seals, the mirrored ramp, v_a
// again. Two of bag length, rate, v_a and v_b are given ("pinned"); the other two follow.
#pragma once

#include "profile/model/law.h"
#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>

namespace campanel::profile {

// The origin of the ratios: set by hand, or those that suit the machine, see ratios.h. Not sent to the
// controller.
enum class RatioMode : std::uint8_t {
    ByHand = 0,
    Gentle = 1,  // minimum peak acceleration
    Cool = 2,    // minimum RMS acceleration
    Slow = 3,    // minimum peak speed
    Between = 4, // at a position between slow, cool and gentle
};

struct RotaryCutterProgram {
    std::array<Field, 2> pinned{Field::BagLength, Field::Rate};
    // Four inputs, of which only the two pinned ones are used.
    double bagLengthMm = info(Field::BagLength).defaultValue;
    double rateBagsPerMin = info(Field::Rate).defaultValue;
    double baseSpeedMmPerS = info(Field::BaseSpeed).defaultValue; // v_a
    double filmSpeedMmPerS = info(Field::FilmSpeed).defaultValue; // v_b
    // The ends of the segments as T/k: k1 > k2 > k3 > k4 > 1.
    Ratios k{info(Field::K1).defaultValue, info(Field::K2).defaultValue, info(Field::K3).defaultValue,
             info(Field::K4).defaultValue};
    LawId speedLaw = LawId::Cubic;
    LawParameters speedLawParameters{};
    double syncRatio = 1; // v_b = syncRatio * L / T
    int slicesPerRamp = static_cast<int>(info(Field::SlicesPerRamp).defaultValue);
    double minSealTimeMs = info(Field::MinSealTime).defaultValue; // that the film needs; 0: none
    RatioMode ratioMode = RatioMode::ByHand;
    double rampPositionPercent = info(Field::RampPosition).defaultValue; // only for Between
};

template <>
inline constexpr std::array membersOf<RotaryCutterProgram>{
    Member<RotaryCutterProgram>{Field::BagLength, &RotaryCutterProgram::bagLengthMm},
    Member<RotaryCutterProgram>{Field::Rate, &RotaryCutterProgram::rateBagsPerMin},
    Member<RotaryCutterProgram>{Field::BaseSpeed, &RotaryCutterProgram::baseSpeedMmPerS},
    Member<RotaryCutterProgram>{Field::FilmSpeed, &RotaryCutterProgram::filmSpeedMmPerS},
    Member<RotaryCutterProgram>{Field::K1, &RotaryCutterProgram::k},
    Member<RotaryCutterProgram>{Field::K2, &RotaryCutterProgram::k},
    Member<RotaryCutterProgram>{Field::K3, &RotaryCutterProgram::k},
    Member<RotaryCutterProgram>{Field::K4, &RotaryCutterProgram::k},
    Member<RotaryCutterProgram>{Field::SyncRatio, &RotaryCutterProgram::syncRatio},
    Member<RotaryCutterProgram>{Field::SlicesPerRamp, &RotaryCutterProgram::slicesPerRamp},
    Member<RotaryCutterProgram>{Field::MinSealTime, &RotaryCutterProgram::minSealTimeMs},
    Member<RotaryCutterProgram>{Field::RampPosition, &RotaryCutterProgram::rampPositionPercent},
};

// The four values of a cycle, of which two are pinned; in the order of the bits of program.pinned.
inline constexpr std::array cycleFields{Field::BagLength, Field::Rate, Field::BaseSpeed, Field::FilmSpeed};
[[nodiscard]] constexpr bool isCycleField(Field field)
{
    return std::ranges::find(cycleFields, field) != cycleFields.end();
}
[[nodiscard]] constexpr bool isRatio(Field field)
{
    return field >= Field::K1 && field <= Field::K4;
}
[[nodiscard]] bool isPinned(const RotaryCutterProgram& program, Field field);

// All numbers of one cycle.
struct CycleNumbers {
    double bagLengthMm = 0;
    double rateBagsPerMin = 0;
    double baseSpeedMmPerS = 0; // v_a
    double filmSpeedMmPerS = 0; // v_b
    double cycleTimeS = 0;      // T
    double strokeMm = 0;        // h = 2 pi R / N
    double weightS = 0;    // W = (tc - tb) + G(1) [(tb - ta) + (td - tc)], so that h = v_a (T - W) + v_b W
    double speedRatio = 0; // k0 = v_b / v_a; infinite when v_a = 0
    double taS = 0;
    double tbS = 0;
    double tcS = 0;
    double tdS = 0;
};

// A solved program: immutable numbers and curves. It may still exceed limits of the machine: see limits.h.
struct RotaryCutter {
    RotaryCutterProgram program;
    Machine machine;
    CycleNumbers cycle;
    MotionProfile motion;

    [[nodiscard]] double angleDegAt(double timeS) const { return 360 * timeS / cycle.cycleTimeS; }
};

// Solves the geometry. Refuses an impossible cycle: values out of range or not finite, k not descending, v_a
// < 0. A refusal names, for each pinned input, the nearest value that makes the whole recipe feasible.
[[nodiscard]] tl::expected<RotaryCutter, Refusal> solve(const RotaryCutterProgram& program,
                                                        const Machine& machine);

// Solves the numbers alone, without curves and without suggestions in the refusal: for searches.
[[nodiscard]] tl::expected<CycleNumbers, Refusal> solveNumbers(const RotaryCutterProgram& program,
                                                               const Machine& machine);

} // namespace campanel::profile
