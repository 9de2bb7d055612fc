// SPDX-License-Identifier: Apache-2.0
// Shared by position and speed moves: the grid of the time field, refusals, and the checked motion. Internal
// to profile/.
#pragma once

#include "profile/model/axis_motion.h"

#include <tl/expected.hpp>

#include <utility>

namespace campanel::profile::detail {

// Returns the refusal of a move without motion, caused by this value of `field`.
[[nodiscard]] Refusal noMotion(Field field, double value);

// Returns the refusal of a move in any time, because friction takes all the peak or rated torque.
[[nodiscard]] Refusal noTorqueLeft(const Machine& machine, Limit limit);

// Rounds the time up to the grid of Field::MoveTime, so that a feasible move stays feasible. Refuses a time
// beyond the range.
[[nodiscard]] tl::expected<double, Refusal> timeOnGrid(double shortestS);

// Returns the motion with its peaks and exceeded limits, without suggestions.
[[nodiscard]] AxisMotion checkedMotion(MotionProfile motion, const Machine& machine);

// Solves a move. `timeOf` returns its time or refuses it, `motionOf` makes the motion of a time, and
// `suggestionsOf` the nearest feasible values for a refusal.
template <typename Program, typename TimeOf, typename MotionOf, typename SuggestionsOf>
[[nodiscard]] tl::expected<AxisMotion, Refusal> solveMove(const Program& program, const Machine& machine,
                                                          TimeOf timeOf, MotionOf motionOf,
                                                          SuggestionsOf suggestionsOf)
{
    tl::expected<double, Refusal> timeS = timeOf(program, machine);
    if (!timeS) {
        timeS.error().nearest = suggestionsOf(program, machine, timeS.error());
        return tl::unexpected(std::move(timeS.error()));
    }
    AxisMotion result = checkedMotion(motionOf(program, *timeS), machine);
    if (!result.broken.empty()) {
        const auto nearest = suggestionsOf(program, machine, result.broken.front());
        for (Refusal& refusal : result.broken)
            refusal.nearest = nearest;
    }
    return result;
}

} // namespace campanel::profile::detail
