// SPDX-License-Identifier: Apache-2.0
// Replays a step table pulse by pulse by its definition, independent of how it was built.
#pragma once

#include "profile/cutter/step_table.h"

#include <numeric>

namespace campanel::profile::test {

inline std::int64_t sumOfPulses(const StepTable& table)
{
    return std::accumulate(table.rows.begin(), table.rows.end(), std::int64_t{0},
                           [](std::int64_t sum, const StepRow& row) { return sum + row.pulses; });
}

inline std::int64_t sumOfTicks(const StepTable& table)
{
    return std::accumulate(table.rows.begin(), table.rows.end(), std::int64_t{0},
                           [](std::int64_t sum, const StepRow& row) { return sum + row.ticks; });
}

// Returns true when every timer constant of the row is within the machine's range, with `extra` pulses added.
inline bool isWithinTimer(const StepRow& row, const Machine& machine, std::int64_t extra = 0)
{
    const std::int64_t pulses = row.pulses + extra;
    if (row.pulses == 0)
        return row.ticks > 0 && extra == 0;
    const std::int64_t shortest = row.ticks / pulses;
    const std::int64_t longest = (row.ticks + pulses - 1) / pulses;
    return pulses <= 65535 && shortest >= minTimerConstant(machine) && longest <= maxTimerConstant(machine);
}

// Calls `pulse` with the tick of every pulse of one cycle.
template <typename Pulse> void replay(const StepTable& table, Pulse pulse)
{
    std::int64_t start = 0;
    for (const StepRow& row : table.rows) {
        for (std::int64_t j = 1; j <= row.pulses; ++j)
            pulse(start + j * row.ticks / row.pulses);
        start += row.ticks;
    }
}

} // namespace campanel::profile::test
