// SPDX-License-Identifier: Apache-2.0
// The press stroke of the servo-press paper in five stages: fast approach (A to B), probing until contact
// with the work piece (C), pressing to a position (D), hold (to E), return (F). The work piece determines C;
// the preview assumes the middle of the possible range.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <array>
#include <cstdint>
#include <tl/expected.hpp>

namespace campanel::profile {

inline constexpr std::size_t pressStages = 5; // approach, probe, press, hold, return
// The rest at B, C and D before the controller checks the position; the rest at D is part of the hold.
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

// Solves the stroke. Refuses inputs out of range, stages that end before they begin or at the same pulse, and
// forces out of order. A refusal names the nearest inputs that alone correct the program. The order of the
// stages is approach < probe end < press position: contact occurs between the first two, pressing beyond
// them. The order of the forces is probe force < largest force, least <= most force at the stop <= largest
// force. Each stage has constant acceleration at both ends. Its ramp lasts whole milliseconds and stays
// within the machine's acceleration. Torque is not a limit of a press; its peak is unknown (NaN). A stroke
// that exceeds limits is solved; `broken` then names the limits and the input that alone corrects the
// program. The limits include those of the table (RampTooLong, TableRange, the pulse frequency of a row).
[[nodiscard]] tl::expected<PressStroke, Refusal> solveStroke(const PressProgram& program,
                                                             const Machine& machine);
// Returns true when solveStroke() succeeds without exceeded limits; the program then has a table.
[[nodiscard]] bool isFeasible(const PressProgram& program, const Machine& machine);
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PressProgram& program, const Machine& machine);

// The table that the controller executes, one row per stage.
struct PressRow {
    std::uint32_t speedHz = 0;  // 0: the hold
    std::int32_t endPulses = 0; // below the upper position
    std::uint32_t forceN = 0;   // approach, probe: contact force; the others: maximum force
    std::uint32_t timeMs = 0;   // ramp from standstill to the speed; in the hold row the hold time

    bool operator==(const PressRow&) const = default;
};

struct PressTable {
    std::array<PressRow, pressStages> rows;
    std::uint32_t cycleTicks = 0; // duration of the preview's stroke, limited to 32 bits
    double positionErrorMm = 0;   // maximum, by rounding to whole pulses
    double speedErrorMmPerS = 0;  // maximum, by rounding to whole Hz
};

// Builds the table. Refuses the same as solveStroke(), and a stroke that exceeds a limit.
[[nodiscard]] tl::expected<PressTable, Refusal> buildPressTable(const PressProgram& program,
                                                                const Machine& machine);

} // namespace campanel::profile
