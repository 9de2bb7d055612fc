// SPDX-License-Identifier: Apache-2.0
// Everything that follows from a recipe, computed at once after each change: well below one frame (27 us for
// the table of a cutter, 10 us for the curves). Only intervals take longer; they may be left for later.
#pragma once

#include "app/link/link_values.h"
#include "app/program/program_image.h"
#include "app/program/recipe.h"
#include "app/program/solved_program.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"

#include <memory>
#include <optional>
#include <vector>

namespace campanel::machine {

struct Solution {
    std::optional<program::SolvedProgram> solved;       // empty: cannot be a motion at all
    std::shared_ptr<const profile::Curves> curves;      // of the solved program
    std::vector<profile::Refusal> refusals;             // empty: the machine can do it
    std::optional<modbus::CodecError> unstorable;       // a value that the controller cannot hold
    std::shared_ptr<const program::ProgramImage> image; // what would be downloaded; null unless feasible
    std::optional<profile::FastestRate> fastest;        // of a rotary cutter
    bool isTablePending = false; // within the limits, the table has been left for later

    // Null unless it is a solved rotary cutter.
    [[nodiscard]] const profile::RotaryCutter* cutter() const
    {
        return solved && solved->cutter ? &*solved->cutter : nullptr;
    }
    [[nodiscard]] bool isFeasible() const { return image != nullptr; }
    // Feasible, but with little to spare.
    [[nodiscard]] bool isCloseToLimit() const;
};

enum class TableWork { All, WithoutSlow };

// With the timer and table size of the controller, when it is known. WithoutSlow leaves intervals out.
[[nodiscard]] Solution solveRecipe(const program::Recipe& recipe,
                                   const std::optional<modbus::Identity>& controller,
                                   TableWork work = TableWork::All);

} // namespace campanel::machine
