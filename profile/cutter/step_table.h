// SPDX-License-Identifier: Apache-2.0
// The step table that the controller executes (given-step method): each row gives a number of pulses and a
// number of timer ticks.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/cutter/table_error.h"

#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

// Pulse j (1..pulses) comes floor(j * ticks / pulses) ticks after the start of the row, so each timer
// constant is floor(ticks / pulses) or one more. A row without pulses is a pause.
struct StepRow {
    std::uint16_t pulses = 0;
    std::uint32_t ticks = 0;

    bool operator==(const StepRow&) const = default;
};

// Returns the mean pulse frequency of a row; 0 for a pause.
[[nodiscard]] inline double frequencyHz(const StepRow& row, const Machine& machine)
{
    return static_cast<double>(row.pulses) * machine.timerClockHz / row.ticks;
}

struct StepTable {
    std::vector<StepRow> rows;
    std::uint32_t cycleTicks = 0; // sum of all ticks = round(T * clock)
    // The rows' pulses sum to pulses.whole. The controller adds pulses.remainder to an accumulator at the
    // start of each cycle. When the accumulator reaches pulses.divisor, the controller subtracts the divisor
    // and adds one pulse to rows[carryRow].
    PulsesPerCycle pulses;
    std::size_t carryRow = 0;
    TableErrors errors;
};

// Builds the table. Refuses rows that do not fit the controller (nearest: slices per ramp, or rate) and
// pulses that do not fit the timer.
[[nodiscard]] tl::expected<StepTable, Refusal> buildStepTable(const RotaryCutter& cutter);

} // namespace campanel::profile
