// SPDX-License-Identifier: Apache-2.0
// The step table that the controller executes (given-step method): rows of so many pulses in so many timer
// ticks.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/cutter/table_error.h"

#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

// Pulse j (1..pulses) comes floor(j * ticks / pulses) ticks after the row's beginning, so each timer constant
// is floor(ticks / pulses) or one more. Without pulses the row is a pause.
struct StepRow {
    std::uint16_t pulses = 0;
    std::uint32_t ticks = 0;

    bool operator==(const StepRow&) const = default;
};

// Mean pulse frequency of a row; 0 for a pause.
[[nodiscard]] inline double frequencyHz(const StepRow& row, const Machine& machine)
{
    return static_cast<double>(row.pulses) * machine.timerClockHz / row.ticks;
}

struct StepTable {
    std::vector<StepRow> rows;
    std::uint32_t cycleTicks = 0; // sum of all ticks = round(T * clock)
    // The rows' pulses sum to pulses.whole. The controller adds pulses.remainder to an accumulator at the
    // beginning of each cycle; when it reaches pulses.divisor, it subtracts that and gives rows[carryRow] one
    // pulse more.
    PulsesPerCycle pulses;
    std::size_t carryRow = 0;
    TableErrors errors;
};

// Refuses when the rows do not fit the controller (nearest: slices per ramp, or rate) or the pulses the
// timer.
[[nodiscard]] tl::expected<StepTable, Refusal> buildStepTable(const RotaryCutter& cutter);

} // namespace campanel::profile
