// SPDX-License-Identifier: Apache-2.0
// The press stroke of the servo-press paper in its five stages: fast approach (A to B), probe until the work
// piece is felt (C), press to a position (D), hold (to E), return (F). Where C lies the work piece decides;
// for the preview it is taken in the middle of where it may lie.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <array>
#include <cstdint>
#include <tl/expected.hpp>

namespace campanel::profile {

inline constexpr std::size_t pressStages = 5; // approach, probe, press, hold, return
// At B, C and D the ram comes to stand before the controller looks where it is; D's is part of the hold.
inline constexpr double pressRestS = 0.02;

struct StageSpan {
    double fromS = 0;
    double toS = 0;
    double fromMm = 0; // below the upper position
    double toMm = 0;
};

struct PressStroke {
    AxisMotion motion; // positions below the upper position; marksS: the four joints between the stages
    std::array<StageSpan, pressStages> stages;
};

// Refuses inputs out of range, stages of which one ends before it begins or at the same pulse (approach <
// probe end < press position: the work piece is touched between the first two and pressed beyond), and forces
// out of order (probe force < largest force, least <= most force at the stop <= largest force), with the
// nearest inputs that alone mend the program. Each stage has constant acceleration at both ends, by a ramp of
// whole milliseconds that needs no more than the machine's acceleration. Torque is no limit of a press and
// its peak not known (NaN). A stroke that asks too much is solved; `broken` then names the limits, those of
// the table among them (RampTooLong, TableRange, the pulse frequency of a row), and the input that alone
// mends the program.
[[nodiscard]] tl::expected<PressStroke, Refusal> solveStroke(const PressProgram& program,
                                                             const Machine& machine);
// True when the above finds nothing wrong; then there is a table.
[[nodiscard]] bool isFeasible(const PressProgram& program, const Machine& machine);
// The motion of solveStroke.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PressProgram& program, const Machine& machine);

// What the controller executes, a row per stage.
struct PressRow {
    std::uint32_t speedHz = 0;  // 0: the hold
    std::int32_t endPulses = 0; // below the upper position
    std::uint32_t forceN = 0;   // approach, probe: felt; the others: largest allowed
    std::uint32_t timeMs = 0;   // ramp from standstill to the speed; of the hold its length

    bool operator==(const PressRow&) const = default;
};

struct PressTable {
    std::array<PressRow, pressStages> rows;
    std::uint32_t cycleTicks = 0; // of the preview's stroke, at most what 32 bits hold
    double positionErrorMm = 0;   // largest, by rounding to whole pulses
    double speedErrorMmPerS = 0;  // largest, by rounding to whole Hz
};

// Refuses what solveStroke refuses, and a stroke that breaks a limit.
[[nodiscard]] tl::expected<PressTable, Refusal> buildPressTable(const PressProgram& program,
                                                                const Machine& machine);

} // namespace campanel::profile
